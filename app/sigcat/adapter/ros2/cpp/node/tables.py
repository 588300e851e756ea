"""Tables of enumerations whose fields are texts."""

from collections.abc import Iterator, Mapping, Sequence

from sigcat.adapter.ros2.plan import NodePlan, Symbol


def symbols_of(node: NodePlan) -> Mapping[str, Sequence[Symbol]]:
    """Texts with their numbers, for each place of the core whose field or parameter is text."""
    return dict(_texts(node))


def _texts(node: NodePlan) -> Iterator[tuple[str, Sequence[Symbol]]]:
    for subscription in node.subscriptions:
        yield from ((each.place, each.symbols) for each in subscription.takes if each.symbols)
    for publisher in node.publishers:
        yield from ((each.place, each.symbols) for each in publisher.gives if each.symbols)
    yield from ((each.parameter.named.name, each.symbols) for each in node.parameters if each.symbols)
