"""The REST service: requests in, answers out, no domain logic.

Dependencies of requests, routes, answers, and the middleware around them.
"""
