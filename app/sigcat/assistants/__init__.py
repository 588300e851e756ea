"""A project and questions of a coding assistant in; bounded answers over the Model Context Protocol out.

It reads, and writes nothing.
"""
