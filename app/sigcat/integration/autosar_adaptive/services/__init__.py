"""Functions with their components in; services with their elements, and the view of each component on them, out.

Interfaces are grouped by component or by branch.
"""
