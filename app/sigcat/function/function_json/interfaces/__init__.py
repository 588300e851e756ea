"""Fields of the interfaces of a call in, checked interfaces out: data, states of the function, and methods.

Each is a model of the published schema.
"""
