"""A run and a file of expected outputs in; what differs, as findings, a table, a picture and a JUnit report, out.

Values are compared as they come: memory does not grow with the length of the run.
"""
