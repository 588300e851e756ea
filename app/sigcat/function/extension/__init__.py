"""A catalogue and what declarations define in; the catalogue with that in it out.

With what the rules of the catalogue say of it, and the same written as an overlay.
"""
