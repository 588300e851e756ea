"""The test RTE: what a vendor's generator makes of the ARXML, for a desk. One core, static, scheduled by times given to it.

It stands for the RTE, the operating system, and the services that components call; of these it records what they were told.
"""
