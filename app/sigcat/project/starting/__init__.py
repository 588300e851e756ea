"""The files that a project starts with: a folder in; texts by path out.

A new project is one that passes; for an existing repository only the project file is made.
"""
