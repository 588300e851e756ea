"""A Function JSON in, what its adapter has to do out: frozen values, with every number resolved.

What no adapter carries is refused with `Unsupported`.
"""
