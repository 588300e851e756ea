"""Functions in, what a host of their cores needs out: what they receive, send and store.

`host_plan.py` is for every platform, the rest for simulation and FMUs: connections of a set, and a file in C that calls each core.
"""
