"""Shapes of columns in; bytes of traces and results, converted by a library in C, out.

The library takes what is plain, and leaves the rest to Python, which gives the same bytes.
"""
