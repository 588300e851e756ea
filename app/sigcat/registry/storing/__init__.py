"""Entries and content in; a database whose tables follow from its log, out.

The log is checked, exported and imported here.
"""
