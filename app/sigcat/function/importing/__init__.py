"""In: the description of a project of C code, and a catalogue.
Out: the text of a function.yaml that lints up to the paths that nobody but its author can choose.
"""
