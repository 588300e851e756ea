"""Connections, before a request is one: their number, their time, and whether what they send is HTTP.

Bytes in; requests for the application out, or a problem.
"""
