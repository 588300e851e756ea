"""A resolved function in; problems of its schedule out.

Order, times, supervision and checkpoints of calls.
"""
