"""Databases of older schemas in; databases of the newest schema out.

Alembic runs `env.py`, and the modules of `versions` in their order.
"""
