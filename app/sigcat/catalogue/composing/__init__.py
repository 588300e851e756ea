"""Statements of all layers in, a `Catalogue` and findings out.

Merge by path, fold into definitions, expand instances, grow the tree.
"""
