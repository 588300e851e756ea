"""Integration JSON for AUTOSAR adaptive in, the files of the platform out.

ARXML for the releases from R20-11 on.
"""
