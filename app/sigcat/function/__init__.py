"""Function files in; checked functions, Function JSON and findings out.

Read with positions, extend the catalogue, resolve each interface, check, write: function_file.py is the whole way.
"""
