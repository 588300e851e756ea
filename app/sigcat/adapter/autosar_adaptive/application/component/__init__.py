"""The plan of a component in, its adapter in C++ out: its header, its source and the copies of structs.

`calls.cpp.j2`, `methods.cpp.j2` and `offered.cpp.j2` have the parts that call the core and are called by it.
"""
