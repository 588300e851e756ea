"""Files to publish, and questions about them, in; what is published, used, deployed and broken, out.

Only `storing` writes. The log is the source: `storing/replay.py` makes every table from its entries.
"""
