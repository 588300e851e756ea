"""Answers of routes: schemas, representations, problems, streams.

Frozen values of the other packages in, HTTP out.
"""
