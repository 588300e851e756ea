"""The language server: texts of an editor and positions in them, in; findings, look-ups and edits, out.

It decides nothing: what is wrong and what a node is come from the rooms below.
"""
