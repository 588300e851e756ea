"""Diagrams: values in, coordinates for SVG templates out.

Units are pixels.
"""
