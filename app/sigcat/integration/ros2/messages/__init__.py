"""Values that topics and services carry in; their messages out.

Messages are made for the set, or exist already.
"""
