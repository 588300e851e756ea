"""A proposed overlay in, what its page shows out: the fields of its form, its patch, and what it changes.

`proposal.py` makes the overlay.
"""
