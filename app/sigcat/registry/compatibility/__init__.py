"""A candidate and what vehicle lines run in; functions that break, and whether it may be deployed, out.

Functions are compared by the checks of a set.
"""
