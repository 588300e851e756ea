"""Bytes of YAML or JSON in; a value out that knows its line and column, with findings of its structure.

Also what every later stage reports in: problems with their subjects.
"""
