"""A composed tree in, the files of an exporter of vss-tools out; nothing else knows vss-tools.

It keeps units in globals and ends its process on bad input: only `worker.py`, run as a script, imports it.
"""
