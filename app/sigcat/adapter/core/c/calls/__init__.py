"""Calls and methods of a plan in, C that calls the code out.

`calls` is what is done before and after each call, `methods` what the function offers to others or uses of them.
"""
