"""A database of one schema in; a database of the next schema out.

Each module is one revision, in the form of Alembic.
"""
