"""Model of VSS for all other packages: datatypes, units, definitions of nodes, interfaces, the frozen `Catalogue`.

Input: statements, as the origins of values. Output: values that never change.
"""
