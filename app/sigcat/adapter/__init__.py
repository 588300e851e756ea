"""An integration model in, the files of a platform out.

Nothing here reads a catalogue or asks a function again.
"""
