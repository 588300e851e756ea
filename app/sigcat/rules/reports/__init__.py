"""Findings in, text out: one file for each format.

For people, editors, build servers and code scanning.
"""
