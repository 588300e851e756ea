"""The plan of a workspace in; launch file, parameter files and README out.

What starts the nodes, and what people read of them.
"""
