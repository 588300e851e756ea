"""Functions in, everything that is made of them for a platform out: whichever platform of one table it is.

One file for each platform says what it brings; its code is in the rooms `integration` and `adapter`.
"""
