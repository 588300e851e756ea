"""Values of the catalogue and of the code in, C that checks, converts and assigns them out.

`literals` writes numbers, `conversions` expressions; `sizes` compares declared types with those that are compiled.
"""
