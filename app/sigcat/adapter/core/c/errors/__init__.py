"""Errors and safety reactions of a plan in, C that sets, counts, clears and reports them out.

Beside them is what sets some of them: conditions of inputs, and the supervision of calls.
"""
