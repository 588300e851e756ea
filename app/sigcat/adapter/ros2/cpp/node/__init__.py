"""The plan of a node in; its header, its source and its main function in C++ out.

A file for each part of the source makes the plan of the template with its name.
"""
