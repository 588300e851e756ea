"""Calls and modes of a plan in, C that says when each call is due, and which ones a mode excludes, out.

`clock` and `times.c.j2` have the times that this is measured by.
"""
