"""Received and sent values, by time: CSV in; values, and CSV, MCAP and pictures of them, out.

Nothing here knows of functions or compilers.
"""
