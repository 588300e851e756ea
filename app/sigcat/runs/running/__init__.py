"""The program of a set and a trace in; rows of sent values, as they arrive, out.

It is a separate process, so that a call that crashes or hangs ends it alone.
"""
