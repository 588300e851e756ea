"""Decisions of the owners of functions in; what waits for them, and what they have decided, out.

`approvals` are of versions that break their functions, `acknowledgements` of versions that are deprecated.
"""
