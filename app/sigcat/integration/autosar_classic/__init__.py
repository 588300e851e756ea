"""From functions to the Integration JSON of AUTOSAR Classic: software components, their ports and behaviour, what they
need of the base software, the composition of them, and the tasks that run them.
"""
