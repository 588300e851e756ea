"""Functions in, Integration JSON for FMI out, whose variables follow from the cores.

That document in, FMUs of FMI 3.0 out: their descriptions, their sources, and a build that packs them.
"""
