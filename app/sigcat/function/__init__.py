"""A function declared once in, Function JSON and findings out.

Documents with positions, models, declaration, building, checks, sets.
"""
