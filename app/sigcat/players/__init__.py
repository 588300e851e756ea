"""Integration JSON comes in; a program goes out that replaces everything around the functions: it sends what they receive
from outside, over the network of their platform, and hears what they send.
"""
