"""Datatypes of the set."""
