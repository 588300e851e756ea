"""Paths in, findings out, with fixes, suppressions, baselines and configuration.

Everything that `sigcat lint` does around the engine.
"""
