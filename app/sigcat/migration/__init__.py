"""Migration: a table of moves, two catalogues and the files of a project in; the changed texts and findings out.

Only `writing.py` writes files.
"""
