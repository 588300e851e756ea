"""A function in, findings out: what is wrong within it, and against the catalogue.

For built functions and for Function JSON from anywhere.
"""
