"""An integration in, the ports out by which a player sends a recorded drive to the applications and records theirs.

Its files that are the same for every integration are in `cpp`.
"""
