"""Bytes in, statements out: YAML with positions, vspec files with their includes, layers.

Nothing here knows what an attribute means.
"""
