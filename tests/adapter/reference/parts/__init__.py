"""One thing each that an adapter is made of: what is declared of it in, what becomes of it with time out.

None knows of calls; `function.py` and `running.py` above put them together.
"""
