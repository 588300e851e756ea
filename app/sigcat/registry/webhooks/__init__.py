"""Events and subscriptions in; signed requests to their addresses, and what became of each, out.

Subscriptions and deliveries are in the database, and not in the log: an export has neither of them.
"""
