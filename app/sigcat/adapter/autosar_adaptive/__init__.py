"""Integration JSON for AUTOSAR adaptive in, the files of the platform out.

ARXML for R23-11.
"""
