"""A declaration and the extended catalogue in; one resolved function out, with the position of every field.

Each interface is resolved once: a resolver yields what is wrong, and returns what it made.
"""
