"""Integration JSON for FMI from anywhere in, a checked model out; the settings of a deployment for it.

The derivation is in `adapter/fmi`: it starts at the plans of cores.
"""
