"""The models of Function JSON: the published schema and its superset.

JSON in, frozen models out, and back, byte for byte.
"""
