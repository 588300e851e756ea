"""The routes, one file for each noun of the API.

Each calls one function of another room and answers with a schema.
"""
