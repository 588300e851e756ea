"""Witnesses of the table of bindings: real tools that pass or fail where the table says compatible or breaking."""
