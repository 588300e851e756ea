"""Routes of pages: an address in, a rendered template out.

One file for each group of pages.
"""
