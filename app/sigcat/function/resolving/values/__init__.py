"""A declared value and its node in the catalogue in; its datatype, unit, range and start value in the code out.

Numbers are exact fractions.
"""
