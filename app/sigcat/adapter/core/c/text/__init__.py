"""Rendered templates in, lines of C out: indented by their braces, and marked with what they were made from.

`parts.c.j2` has parts of declarations and comments that many templates need.
"""
