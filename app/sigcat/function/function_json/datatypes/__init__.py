"""Datatypes of VSS and of C in, those that interfaces of a function refer to out.

`primitive_types` has a row for each; `type_list` gathers those of a function.
"""
