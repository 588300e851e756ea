"""Integration JSON for AUTOSAR Classic in, ARXML out: types to components, ECU extract, diagnosis, ECU configuration.

Pure functions make elements; `adapter/arxml` writes them.
"""
