"""What routes answer with: schemas, representations, problems, streams.

Frozen values of the other rooms in, HTTP out.
"""
