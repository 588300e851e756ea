"""The program of a set and a trace in; rows of what was sent, as they come, out.

It is a process of its own, so that a call that crashes or hangs ends it alone.
"""
