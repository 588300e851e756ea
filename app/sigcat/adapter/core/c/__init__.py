"""The plan of a core in, its header and its source in C out.

There is a template for each section of docs/reference/adapter.md, and a file beside it that resolves the names, numbers and expressions of its
plan; none decides what the plan of the core has not decided.
"""
