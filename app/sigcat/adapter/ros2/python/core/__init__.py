"""The plan of a core in; its module in Python, and the bridge in C between both, out.

The module has declarations of the bridge, and compares the layout of structs.
"""
