"""Fields of what a call exchanges in, checked interfaces out: data, states of the function, and methods.

Each is a model of the published schema.
"""
