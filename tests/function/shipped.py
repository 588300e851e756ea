"""The shipped catalogue with the interface overlays, composed once, and the examples."""

from functools import cache

from sigcat.catalogue.hosting.library import load, shipped_sources
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.data import EXAMPLES

FUNCTIONS = sorted(EXAMPLES.glob("*/function.yaml"))


@cache
def interfaces() -> Catalogue:
    """VSS with the overlays of data, errors, safety reactions, modes and scheduling."""
    return load(next(source for source in shipped_sources() if source.id == "interfaces"))
