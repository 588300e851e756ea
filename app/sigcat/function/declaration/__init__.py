"""A `function.yaml` in; a frozen declaration out, and its document.

Everything that the catalogue knows is left to the catalogue.
"""
