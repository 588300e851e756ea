"""Functions and the settings of AUTOSAR adaptive in; Integration JSON for it, findings and a report out.

Components, executables and service interfaces are derived; `adaptive_integration.py` is the whole way.
"""
