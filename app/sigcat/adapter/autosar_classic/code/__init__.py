"""Software components in C99 by the conventions of the RTE, around the core of each function.

`plan` has each component beside its core, with every name resolved, and templates read it.
"""
