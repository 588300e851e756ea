"""A `Catalogue` in, files out: JSON and static ids of our own, every other format through vss-tools.

`exporters.py` is the table of exporters. Only the folder vss_tools knows vss-tools.
"""
