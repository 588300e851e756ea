"""The catalogue: vspec files in, one frozen tree of nodes out, in which every value knows file, line and overlay.

Reading, model, composing; then search, exporting, hosting and comparing.
"""
