"""The plan of a workspace in, the package of nodes in C++ out: a lifecycle node around each core.

Files that are the same in every package are in `support`.
"""
