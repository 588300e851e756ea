"""A `function.yaml` in; a frozen declaration out, and the document that it stands in.

Everything that the catalogue knows is left to the catalogue.
"""
