"""Elements of ARXML as plain values, and what both platforms of AUTOSAR write alike.

Only `tree.py` knows the library that writes them.
"""
