"""The plan of a workspace in, the package in Python out: the same nodes over the same cores, for tests and notebooks.

Files that are the same in every package are in `support`.
"""
