"""Acceptance tests of the registry."""
