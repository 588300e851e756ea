"""Inputs, outputs and parameters of a plan in, C that receives, takes, sends and stores their values out.

An input has two templates: `receiving.c.j2` runs in any thread, `inputs.c.j2` takes snapshots for calls.
"""
