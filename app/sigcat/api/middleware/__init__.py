"""Steps that every request passes before and after its route.

Access, the log, metrics, and answers that are kept.
"""
