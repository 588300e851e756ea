"""Functions with their sources and a recorded trace in; what they send, and when they were called, out.

The only room that runs a compiler, or what it made. The service is not allowed to use that part of it.
"""
