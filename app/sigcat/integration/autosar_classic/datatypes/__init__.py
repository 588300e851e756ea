"""Types of functions in; implementation and application types of the set out.

Platform types come from AUTOSAR.
"""
