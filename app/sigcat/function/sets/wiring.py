"""Wiring of a set of functions: providers and consumers, signals from outside, and mismatches."""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from sigcat.function.exchange import Side, causes, exchange_of, parts_of
from sigcat.function.function_json.interfaces.role import CONSUMER
from sigcat.function.function_json.interfaces.status_interfaces import SafetyReaction
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.sets.fit import Mismatch, mismatches


class Link(NamedTuple):
    """A signal that one function provides and another one consumes."""

    path: str
    provider: Side
    consumer: Side
    mismatches: tuple[Mismatch, ...]


class Rivals(NamedTuple):
    """A signal that several functions provide."""

    path: str
    providers: tuple[Side, ...]
    """The first end of each of them."""

    @property
    def functions(self) -> tuple[str, ...]:
        """Names of the functions."""
        return tuple(end.function for end in self.providers)


class Wiring(NamedTuple):
    """A set of functions, connected."""

    functions: tuple[str, ...]
    links: tuple[Link, ...]
    from_outside: tuple[Side, ...]
    """Consumed, and provided by no function of the set."""
    to_outside: tuple[Side, ...]
    """Provided, and consumed by no function of the set."""
    rivals: tuple[Rivals, ...]
    unreported: tuple[tuple[str, str, str], ...]
    """(function, safety reaction, error): errors of no function of the set that a reaction waits for."""


def connect(functions: Sequence[FunctionJson]) -> Wiring:
    """The wiring of functions. A signal that a function provides to itself is not a link."""
    exchange = exchange_of(parts_of(functions))
    providers = _by_path(side for side in exchange.data if side.provides)
    consumers = _by_path(side for side in exchange.data if side.data.role == CONSUMER)
    links = (link for path, each in consumers.items() for link in _links(providers.get(path, ()), each))
    rivals = (Rivals(path, tuple(_first_of_each(each))) for path, each in providers.items())
    reactions = (side for side in exchange.sides if isinstance(side.interface, SafetyReaction))
    return Wiring(
        tuple(function.info.function_name for function in functions),
        tuple(links),
        tuple(side for path, each in consumers.items() if path not in providers for side in each),
        tuple(side for path, each in providers.items() if path not in consumers for side in each),
        tuple(each for each in rivals if len(each.providers) > 1),
        tuple(
            (side.function, side.identity, error)
            for side in reactions
            for error in causes(side.interface)
            if not exchange.elements["error", error].providers
        ),
    )


def _by_path(sides: Iterable[Side]) -> dict[str, list[Side]]:
    """Sides of one signal together."""
    grouped: dict[str, list[Side]] = {}
    for side in sides:
        grouped.setdefault(side.identity, []).append(side)
    return grouped


def _links(providers: Sequence[Side], consumers: Sequence[Side]) -> Iterator[Link]:
    """Each consumer of a signal with its provider. A further function that provides it has a link to one consumer.

    Not every pair: a signal that a thousand calls give and take would have a million.
    """
    giving, taking = _first_of_each(providers), _first_of_each(consumers)
    linked = set[str]()
    for consumer in consumers:
        provider = _other(consumer, giving)
        if provider is not None:
            linked.add(provider.function)
            yield _link(provider, consumer)
    for rival in giving:
        taker = _other(rival, taking)
        if taker is not None and rival.function not in linked:
            yield _link(rival, taker)


def _link(provider: Side, consumer: Side) -> Link:
    return Link(consumer.identity, provider, consumer, tuple(mismatches(provider, consumer)))


def _first_of_each(ends: Iterable[Side]) -> list[Side]:
    """The first end of each function."""
    first: dict[str, Side] = {}
    for end in ends:
        first.setdefault(end.function, end)
    return list(first.values())


def _other(end: Side, others: Iterable[Side]) -> Side | None:
    return next((other for other in others if other.function != end.function), None)
