"""The signals of a catalogue that come from CAN: each with its mapping, its datatype and the values that it may have."""

from collections.abc import Iterator
from typing import Any, NamedTuple

from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.datatypes import PRIMITIVES
from sigcat.catalogue.model.definition import SIGNALS
from sigcat.catalogue.model.interfaces import interface_name
from sigcat.catalogue.network.mapping import SignalMapping, mappings_of
from sigcat.catalogue.network.mapping_attributes import RECEIVED
from sigcat.catalogue.network.network_values import Unfit, Value, in_datatype


class Mapped(NamedTuple):
    """A signal that comes from CAN."""

    path: str
    name: str
    """Name of its column: its path, or of a mode, an error or a safety reaction the name of the interface."""
    datatype: str
    allowed: frozenset[Any]
    mapping: SignalMapping
    default: Value | None = None
    """Value before one is received."""


def mapped_signals(catalogue: Catalogue) -> tuple[Mapped, ...]:
    """The signals that one of the two mappings names, in the order of the catalogue. Of two mappings, the first counts."""
    return tuple(each for node in catalogue.nodes.values() for each in _mapped(node))


def _mapped(node: Node) -> Iterator[Mapped]:
    datatype = node.values.get("datatype")
    if node.definition.type not in SIGNALS or datatype not in PRIMITIVES:
        return
    mapping = next(mappings_of(node.values, RECEIVED), None)
    allowed = node.values.get("allowed")
    if mapping is not None:
        yield Mapped(
            node.path,
            interface_name(node.path),
            datatype,
            frozenset(allowed if isinstance(allowed, list) else ()),
            mapping,
            _default(node, mapping, datatype),
        )


def _default(node: Node, mapping: SignalMapping, datatype: str) -> Value | None:
    """Lint reports one that is not a value."""
    given = node.values[mapping.attribute].get("default") if mapping.is_profile else None
    try:
        return None if given is None or isinstance(given, dict | list) else in_datatype(given, datatype)
    except Unfit:
        return None
