"""A function in, an adapter that behaves as docs/reference/adapter.md says out: in Python, exact, and slow.

Written from that page alone: it shares nothing with what generates C, so that the two can be compared.
"""
