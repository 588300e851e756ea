"""In: the description of a project of C code, and a catalogue.
Out: the text of a function.yaml that lints except for the paths that only its author can choose.
"""
