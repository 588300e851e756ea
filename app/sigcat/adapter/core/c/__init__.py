"""The plan of a core in, its header and its source in C out.

Each section of docs/reference/adapter.md has a template, beside the file that resolves its names, numbers and expressions.
"""
