"""Several functions in, their wiring and what does not fit out.

Who provides what to whom, and what comes from outside.
"""
