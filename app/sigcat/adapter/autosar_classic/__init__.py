"""Integration JSON of AUTOSAR Classic in; ARXML, and the components in C, out.

Elements that both platforms of AUTOSAR have are in `adapter/arxml`.
"""
