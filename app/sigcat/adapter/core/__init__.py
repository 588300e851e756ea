"""A resolved function in, its adapter core in C out: no platform, no clock, no lock.

`plan` says what the core has to do, with every number resolved; `c` writes it. What it means: docs/reference/adapter.md.
"""
