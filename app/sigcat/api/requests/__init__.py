"""Inputs that routes take from a request: the hosted catalogue, the posted text, the cursor.

HTTP in, frozen values of the other packages out.
"""
