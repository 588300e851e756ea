"""The test RTE: what a vendor's generator makes of the ARXML, for a desk. One core, static, scheduled by times given to it.

It replaces the RTE, the operating system, and the services that components call. It records calls of these services.
"""
