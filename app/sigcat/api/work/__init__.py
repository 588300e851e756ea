"""Functions with their arguments come in, from requests that cannot be answered at once.

Their results go out, from processes that are ended when they take too long or too much.
"""
