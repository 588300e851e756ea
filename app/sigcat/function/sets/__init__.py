"""Checked functions in; how they are connected, and what does not fit between them, out.

A function that fits alone may not fit with the others.
"""
