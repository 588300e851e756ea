"""The public Python API: folders, releases, texts and function files in; catalogues, nodes, findings and runs out.

It prints nothing, starts no service, and loads what a call needs when it is called.
"""
