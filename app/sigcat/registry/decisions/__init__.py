"""What the owners of functions say in, what waits for them and what they have decided out.

`approvals` are of versions that break their functions, `acknowledgements` of versions that are deprecated.
"""
