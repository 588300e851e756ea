"""A `Catalogue` in, files out: JSON and static ids of our own, every other format through vss-tools.

The only room that knows vss-tools.
"""
