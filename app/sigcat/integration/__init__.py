"""Functions in, the Integration JSON of a platform and a report of every field out.

One pure `derive` for each platform, over one datatype table.
"""
