"""The plan of a core in, its header and its source in C out.

There is a file for each section of docs/reference/adapter.md; none decides what the plan has not decided.
"""
