"""The plan of a core in, its prefixes and the expressions that reach the variables of the code out.

A variable of the code that a variable of the adapter would hide is renamed here.
"""
