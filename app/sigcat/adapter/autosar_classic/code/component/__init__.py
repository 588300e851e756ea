"""The plan of a software component in, its source in C out: runnables around the core.

`receiving` and `publishing` take values from the RTE and give it those of the core; `rte_values` copies them.
"""
