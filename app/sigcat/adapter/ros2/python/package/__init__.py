"""The plan of a workspace in; package.xml, setup.py, setup.cfg and tests of the package in Python out.

The modules of nodes and cores are elsewhere.
"""
