"""The plan of a node in; its header, its source and its main function in C++ out.

A file for each part of the source has the functions that its template calls for what C++ writes of the plan.
"""
