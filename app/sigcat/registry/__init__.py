"""Files to publish, and questions about them, in; what is published, used, deployed and broken, out.

`storing` writes. The log is the source: `storing/replay.py` makes the tables from its entries. `webhooks` has separate tables, and sends
the events of the log.
"""
