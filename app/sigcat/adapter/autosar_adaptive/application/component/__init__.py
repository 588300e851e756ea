"""The plan of a component in, its adapter in C++ out: its header, its source and the copies of structs.

`calls` and `methods` have the parts of the source that call the core and are called by it.
"""
