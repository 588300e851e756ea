"""The plan of a software component in, the headers of the contract phase out, which the RTE of an ECU replaces.

`api` says which functions of the RTE a component has, `literals` its constants.
"""
