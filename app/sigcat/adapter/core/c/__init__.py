"""The plan of a core in, its header and its source in C out.

A template for each section of docs/reference/adapter.md is beside the file that resolves its names, numbers and expressions.
"""
