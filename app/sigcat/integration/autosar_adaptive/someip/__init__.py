"""Ids, versions and segments of services over SOME/IP."""
