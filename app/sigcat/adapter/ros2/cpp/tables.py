"""Tables of enumerations whose fields are texts."""

from collections.abc import Iterator

from sigcat.adapter.ros2.cpp.layout import indented, text
from sigcat.adapter.ros2.cpp.names import table
from sigcat.adapter.ros2.plan import NodePlan, Symbol
from sigcat.adapter.text_filters import c_string


def symbol_tables(node: NodePlan) -> list[str]:
    """A table for each place of the core whose field or parameter is text."""
    return [_table(name, symbols) for name, symbols in dict(_texts(node)).items()]


def _texts(node: NodePlan) -> Iterator[tuple[str, tuple[Symbol, ...]]]:
    for subscription in node.subscriptions:
        yield from ((table(each.place), each.symbols) for each in subscription.takes if each.symbols)
    for publisher in node.publishers:
        yield from ((table(each.place), each.symbols) for each in publisher.gives if each.symbols)
    for parameter in node.parameters:
        if parameter.symbols:
            yield table(parameter.parameter.named.name), parameter.symbols


def _table(name: str, symbols: tuple[Symbol, ...]) -> str:
    rows = ",\n".join(f"{{{c_string(each.text)}, {each.number}}}" for each in symbols)
    return text([f"constexpr Symbol {name}[] = {{", indented(rows), "};"])
