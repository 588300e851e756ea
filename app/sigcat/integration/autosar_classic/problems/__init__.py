"""An Integration JSON in; problems for which an RTE generator would refuse it out.

Each file checks one kind of part.
"""
