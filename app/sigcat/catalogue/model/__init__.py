"""What everything else knows of VSS: datatypes, units, definitions of nodes, interfaces, the frozen `Catalogue`.

Statements come in as the origins of values; what goes out are values that never change.
"""
