"""A `function.yaml` in, a frozen declaration out.

Everything that the catalogue knows is left to the catalogue.
"""
