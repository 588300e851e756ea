"""Tables of enumerations whose fields are texts."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sigcat.adapter.ros2.cpp.names import table
from sigcat.adapter.ros2.plan import NodePlan, Symbol


class SymbolTable(NamedTuple):
    """Texts of a place of the core, with their numbers."""

    name: str
    symbols: Sequence[Symbol]


def symbol_tables(node: NodePlan) -> Sequence[SymbolTable]:
    """A table for each place of the core whose field or parameter is text."""
    return [SymbolTable(table(place), symbols) for place, symbols in dict(_texts(node)).items()]


def _texts(node: NodePlan) -> Iterator[tuple[str, Sequence[Symbol]]]:
    for subscription in node.subscriptions:
        yield from ((each.place, each.symbols) for each in subscription.takes if each.symbols)
    for publisher in node.publishers:
        yield from ((each.place, each.symbols) for each in publisher.gives if each.symbols)
    yield from ((each.parameter.named.name, each.symbols) for each in node.parameters if each.symbols)
