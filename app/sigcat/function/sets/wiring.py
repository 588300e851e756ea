"""Wiring of a set of functions: providers and consumers, signals from outside, and mismatches."""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.runnable import Contract, Runnable
from sigcat.function.function_json.walk import data
from sigcat.function.sets.ends import Datum, End
from sigcat.function.sets.fit import Mismatch, mismatches

__all__ = ["End", "Link", "Wiring", "calls_of", "connect", "data_of"]


class Link(NamedTuple):
    """A signal that one function provides and another one consumes."""

    path: str
    provider: End
    consumer: End
    mismatches: tuple[Mismatch, ...]


class Rivals(NamedTuple):
    """A signal that several functions provide."""

    path: str
    providers: tuple[End, ...]
    """The first end of each of them."""

    @property
    def functions(self) -> tuple[str, ...]:
        """Names of the functions."""
        return tuple(end.function for end in self.providers)


class Wiring(NamedTuple):
    """A set of functions, connected."""

    functions: tuple[str, ...]
    links: tuple[Link, ...]
    from_outside: tuple[End, ...]
    """Consumed, and provided by no function of the set."""
    to_outside: tuple[End, ...]
    """Provided, and consumed by no function of the set."""
    rivals: tuple[Rivals, ...]
    unreported: tuple[tuple[str, str, str], ...]
    """(function, safety reaction, error): errors of no function of the set that a reaction waits for."""


def connect(functions: Sequence[FunctionJson]) -> Wiring:
    """The wiring of functions. A signal that a function provides to itself is not a link."""
    ends = [end for function in functions for end in ends_of(function)]
    providers = by_path(end for end in ends if end.is_provider)
    consumers = by_path(end for end in ends if end.is_consumer)
    links = (link for path, each in consumers.items() for link in _links(providers.get(path, ()), each))
    rivals = (Rivals(path, tuple(_first_of_each(each))) for path, each in providers.items())
    return Wiring(
        tuple(function.info.function_name for function in functions),
        tuple(links),
        tuple(end for path, each in consumers.items() if path not in providers for end in each),
        tuple(end for path, each in providers.items() if path not in consumers for end in each),
        tuple(each for each in rivals if len(each.providers) > 1),
        tuple(_unreported(functions)),
    )


def calls_of(function: FunctionJson) -> Iterator[Runnable]:
    """Every call of a function."""
    for component in function.components:
        yield from component.runnables


def data_of(contract: Contract) -> Iterator[Datum]:
    """Signals and queues of a contract."""
    yield from contract.signals or ()
    yield from contract.queues or ()


def ends_of(function: FunctionJson) -> Iterator[End]:
    """Every signal and queue of a function, each once for each call that uses it."""
    return (End(function, pointer, located.runnable, signal) for pointer, located, signal in data(function))


def by_path(ends: Iterable[End]) -> dict[str, list[End]]:
    """Ends of one signal together."""
    grouped: dict[str, list[End]] = {}
    for end in ends:
        grouped.setdefault(end.path, []).append(end)
    return grouped


def _links(providers: Sequence[End], consumers: Sequence[End]) -> Iterator[Link]:
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


def _link(provider: End, consumer: End) -> Link:
    return Link(consumer.path, provider, consumer, tuple(mismatches(provider, consumer)))


def _first_of_each(ends: Iterable[End]) -> list[End]:
    """The first end of each function."""
    first: dict[str, End] = {}
    for end in ends:
        first.setdefault(end.function, end)
    return list(first.values())


def _other(end: End, others: Iterable[End]) -> End | None:
    return next((other for other in others if other.function != end.function), None)


def _unreported(functions: Sequence[FunctionJson]) -> Iterator[tuple[str, str, str]]:
    contracts = [
        (f.info.function_name, contract) for f in functions for call in calls_of(f) for contract in call.contracts or ()
    ]
    reported = {error.name for _, contract in contracts for error in contract.errors or ()}
    for name, contract in contracts:
        for reaction in contract.safety_reactions or ():
            yield from ((name, reaction.name, error) for error in reaction.errors if error not in reported)
