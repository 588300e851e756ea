"""The language server: texts of an editor and positions in them, in; findings, look-ups and edits, out.

It has no rules and no catalogue: findings and nodes are made by the rooms below.
"""
