"""The datatypes of an integration model in, a header for each out, and the codecs that make bytes of those that are sent.

The headers are those of implementation datatypes in the ARXML, the codecs those of SOME/IP.
"""
