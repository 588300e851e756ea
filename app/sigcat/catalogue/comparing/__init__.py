"""Two catalogues in, classified changes out; an overlay in, what it would change out.

A side is a folder, a file, an exported JSON, a git revision or a release.
"""
