"""A resolved function in; problems out: of the function in itself, its conventions, and beside the catalogue.

Problems that only follow from others are left out.
"""
