"""An integration and the plans of its cores in, the plan of the applications out.

`elements` finds what a core has for each element of a service, `threads` which calls run in one thread.
"""
