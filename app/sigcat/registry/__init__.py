"""Files to publish, and questions about them, in; what is published, used, deployed and broken, out.

The log is the source: `storing/replay.py` makes every table from its entries, except those of `webhooks`.
"""
