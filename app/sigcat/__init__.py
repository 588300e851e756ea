"""sigcat: a signal catalogue and interface standardization service."""

__version__ = "0.1.0"
