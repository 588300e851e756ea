"""Bytes in, a document out whose every value knows its line and column.

Also the findings about structure that both kinds of function file share.
"""
