"""Function JSON in; a resolved function out, and back to the same bytes.

The models are the published schema and what later stages need beside it.
"""
