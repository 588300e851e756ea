"""Functions in, what a host of their cores needs out: what they receive, send and keep, and a file in C that calls each by one table.

Hosts are the simulation and FMUs. The platforms have their own.
"""
