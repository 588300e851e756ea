"""A value of one side in, what it is on the other side out: formats of numbers, limits, conversions.

Nothing here knows of functions, or of time.
"""
