"""An integration model in, the plan of each service out, and its proxy, its skeleton, its tables and its errors in C++.

`unusable_names` finds what ARXML permits and C++ does not.
"""
