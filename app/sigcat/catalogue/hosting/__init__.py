"""Names of trees in, catalogues that a process keeps and reloads out.

Shipped trees, pulled releases, `sigcat.toml`, and variants with overlays switched off.
"""
