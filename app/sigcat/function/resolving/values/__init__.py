"""Values in the code of a function: datatype, unit, range, start value."""
