"""The plan of a node in; its module in Python out.

What all nodes have in common is in `support`.
"""
