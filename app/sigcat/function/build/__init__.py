"""A declaration and a catalogue in, a resolved function out.

The catalogue is extended by what the file defines; then each interface is resolved once.
"""
