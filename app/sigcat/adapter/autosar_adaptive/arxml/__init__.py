"""Integration JSON for AUTOSAR adaptive in, four ARXML files out: types, interfaces, components, deployment.

Pure functions make elements; only `tree.py` knows the library that writes them.
"""
