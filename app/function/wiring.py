"""Who provides what to whom in a set of functions, what comes from outside, and what does not fit."""

from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from app.function.asil import level_of, rank
from app.function.model import PROVIDER, Contract, DataQueue, FunctionJson, Runnable, Signal, milliseconds


class End(NamedTuple):
    """A signal at a call of a function."""

    function: str
    call: str
    cycle: float | None
    """Time from one call to the next, in ms; None for a call that is not cyclic."""
    signal: Signal | DataQueue

    @property
    def path(self) -> str:
        """What both ends of a link have in common: the VSS path, or the name where a document has none."""
        return self.signal.vss_path or self.signal.name

    @property
    def is_provider(self) -> bool:
        """Whether the call writes the signal."""
        return self.signal.role == PROVIDER


class Link(NamedTuple):
    """A signal that one function provides and another one consumes."""

    path: str
    provider: End
    consumer: End
    flaws: tuple[str, ...]
    """What does not fit, each as a sentence."""


class Wiring(NamedTuple):
    """A set of functions, connected."""

    functions: tuple[str, ...]
    links: tuple[Link, ...]
    from_outside: tuple[End, ...]
    """Consumed, and provided by no function of the set."""
    to_outside: tuple[End, ...]
    """Provided, and consumed by no function of the set."""
    rivals: tuple[tuple[str, tuple[str, ...]], ...]
    """Paths that several functions provide, with their names."""
    unreported: tuple[tuple[str, str, str], ...]
    """(function, safety reaction, error): errors of no function of the set that a reaction waits for."""


def connect(functions: Sequence[FunctionJson]) -> Wiring:
    """The wiring of functions. A signal that a function provides to itself is no link."""
    ends = [end for function in functions for end in ends_of(function)]
    providers = _by_path(end for end in ends if end.is_provider)
    consumers = _by_path(end for end in ends if not end.is_provider)
    links = tuple(
        Link(path, provider, consumer, tuple(_flaws(provider, consumer)))
        for path, consuming in consumers.items()
        for consumer in consuming
        for provider in providers.get(path, ())
        if provider.function != consumer.function
    )
    rivals = [(path, tuple(dict.fromkeys(end.function for end in each))) for path, each in providers.items()]
    return Wiring(
        tuple(function.info.function_name for function in functions),
        links,
        tuple(end for path, each in consumers.items() if path not in providers for end in each),
        tuple(end for path, each in providers.items() if path not in consumers for end in each),
        tuple((path, names) for path, names in rivals if len(names) > 1),
        tuple(_unreported(functions)),
    )


def calls_of(function: FunctionJson) -> Iterator[Runnable]:
    """Every call of a function."""
    for component in function.components:
        yield from component.runnables


def data_of(contract: Contract) -> Iterator[Signal | DataQueue]:
    """Signals and queues of a contract."""
    yield from contract.signals or ()
    yield from contract.queues or ()


def ends_of(function: FunctionJson) -> Iterator[End]:
    """Every signal and queue of a function, each once for each call that uses it."""
    for call in calls_of(function):
        cycle = float(call.cycle_time) if call.cycle_time is not None else None
        for contract in call.contracts or ():
            for signal in data_of(contract):
                yield End(function.info.function_name, call.name, cycle, signal)


def _by_path(ends: Iterable[End]) -> dict[str, list[End]]:
    grouped: dict[str, list[End]] = {}
    for end in ends:
        grouped.setdefault(end.path, []).append(end)
    return grouped


def _unreported(functions: Sequence[FunctionJson]) -> Iterator[tuple[str, str, str]]:
    contracts = [
        (f.info.function_name, contract) for f in functions for call in calls_of(f) for contract in call.contracts or ()
    ]
    reported = {error.name for _, contract in contracts for error in contract.errors or ()}
    for name, contract in contracts:
        for reaction in contract.safety_reactions or ():
            yield from ((name, reaction.name, error) for error in reaction.errors if error not in reported)


# -- what does not fit ------------------------------------------------------------------------------------------------


def _flaws(provider: End, consumer: End) -> Iterator[str]:
    yield from _other_meaning(provider.signal, consumer.signal)
    yield from _other_range(provider.signal, consumer.signal)
    given, wanted = level_of(provider.signal.asil_level), level_of(consumer.signal.asil_level)
    if given and wanted and rank(given) < rank(wanted):
        yield f"It is provided with {_shown(given)}, and consumed with {_shown(wanted)}."
    timeout = milliseconds(consumer.signal.timeout)
    if timeout and provider.cycle and provider.cycle > timeout:
        yield f"It comes every {provider.cycle:g} ms, and its consumer waits for {timeout:g} ms at most."


def _other_meaning(given: Signal | DataQueue, wanted: Signal | DataQueue) -> Iterator[str]:
    pairs = (
        ("datatype", given.vss_datatype or given.datatype, wanted.vss_datatype or wanted.datatype),
        ("unit", given.vss_unit or given.units, wanted.vss_unit or wanted.units),
    )
    for what, one, other in pairs:
        if (one or "") != (other or ""):
            yield f"It is provided with {what} {one or 'none'}, and consumed with {other or 'none'}."


def _other_range(given: Signal | DataQueue, wanted: Signal | DataQueue) -> Iterator[str]:
    """Values that are provided and not expected. Both ranges are taken to the catalogue's unit."""
    low, high = _in_catalogue_unit(given, given.min), _in_catalogue_unit(given, given.max)
    least, most = _in_catalogue_unit(wanted, wanted.min), _in_catalogue_unit(wanted, wanted.max)
    if low is not None and least is not None and low < least - _slack(least):
        yield f"Values down to {low:g} are provided, and values from {least:g} on are expected."
    if high is not None and most is not None and high > most + _slack(most):
        yield f"Values up to {high:g} are provided, and values up to {most:g} are expected."


def _slack(bound: float) -> float:
    return abs(bound) * 1e-6 + 1e-9


def _in_catalogue_unit(signal: Signal | DataQueue, value: float | None) -> float | None:
    if value is None:
        return None
    try:
        return float(signal.conversion_factor or 1) * value + float(signal.conversion_offset or 0)
    except ValueError:
        return None


def _shown(level: str) -> str:
    return "QM" if level == "QM" else f"ASIL {level}"
