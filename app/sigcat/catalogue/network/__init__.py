"""Attributes that map a signal to one of a network come in, as VSS's network serialization profile and KUKSA write them; a CAN
database too. Mappings with their formulas go out, and what the database says of their signals."""
