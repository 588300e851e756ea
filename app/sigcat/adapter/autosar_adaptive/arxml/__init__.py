"""Integration JSON for AUTOSAR adaptive in, four ARXML files out: types, interfaces, components, deployment.

Pure functions make elements; `adapter/arxml` writes them.
"""
