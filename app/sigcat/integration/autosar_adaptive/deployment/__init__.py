"""The deployment file in; its section on AUTOSAR adaptive out.

Identifiers, namespaces, transport and SOME/IP settings are checked here.
"""
