"""A declaration and the extended catalogue in; one resolved function out, with the position of every field.

Each interface is resolved once: a resolver returns its result, and adds problems to the context.
"""
