"""The shipped catalogue with the interface overlays, composed once, and the examples."""

from functools import cache

from sigcat.catalogue.hosting.library import load, shipped_sources
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.data import EXAMPLES
from sigcat.function.document.read_json import read_json
from sigcat.function.function_json.model import FunctionJson, to_json
from sigcat.function.function_json.resolved_function import ResolvedFunction

FUNCTIONS = sorted(EXAMPLES.glob("*/function.yaml"))


@cache
def interfaces() -> Catalogue:
    """VSS with the overlays of data, errors, safety reactions, modes and scheduling."""
    return load(next(source for source in shipped_sources() if source.id == "interfaces"))


def resolved(function: FunctionJson) -> ResolvedFunction:
    """A function with the document that it would be read from."""
    return ResolvedFunction(function, read_json(to_json(function), f"{function.info.function_name}.json"))
