"""The one door to vss-tools: its exporters, run in a process of their own on the tree that sigcat composed.

Nothing in this process imports vss-tools: it keeps units and types in globals and ends the process on bad input.
`worker.py` is the only file that imports it, and it runs as a script.
"""
