"""An integration and the plans of its cores in, the plan of the software components out.

`ends` and `operations` find what a core has for each data element and operation; `disagreements` what it lacks.
"""
