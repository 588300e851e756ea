"""Connections and mappings of events to tasks that an RTE generator would refuse."""

from collections.abc import Iterator, Mapping
from math import isfinite

from sigcat.function.document.document import Pointer
from sigcat.integration.autosar_classic.model import ClassicIntegration, Event, Port, TaskEvent
from sigcat.integration.autosar_classic.problems.problem import name
from sigcat.integration.autosar_classic.signal_lengths import needs_of
from sigcat.integration.problem import Problem
from sigcat.integration.references import places, unknown

LONGEST_SIGNAL = 512
"""Bits of a frame of CAN FD."""


def connection_problems(model: ClassicIntegration) -> Iterator[Problem]:
    """Connectors whose ends do not fit, and required ports that have none."""
    types = {
        **{each.name: each.ports for each in model.components},
        **{each.name: each.ports for each in model.parameter_components},
    }
    ports = {(each.name, port.name): port for each in model.composition.prototypes for port in types.get(each.type, ())}
    outer = {port.name: port for port in model.composition.ports}
    at: Pointer = ("Composition",)
    writers: dict[tuple[str, str], str] = {}
    for index, assembly in enumerate(model.composition.assemblies):
        here: Pointer = (*at, "Assemblies", index)
        given = assembly.provider.component, assembly.provider.port
        taken = assembly.requester.component, assembly.requester.port
        yield from _ends(ports.get(given), ports.get(taken), here)
        if writers.setdefault(taken, assembly.name) != assembly.name:
            yield Problem(here, f"{'.'.join(taken)} must be connected with one provider: {writers[taken]} connects it already.", "Take one away.")  # fmt: skip
    for index, delegation in enumerate(model.composition.delegations):
        here = (*at, "Delegations", index)
        inner, border = ports.get((delegation.inner.component, delegation.inner.port)), outer.get(delegation.outer)
        if inner is None or border is None:
            yield unknown(here, "port", delegation.outer if border is None else delegation.inner.port)
        elif (inner.interface, inner.direction) != (border.interface, border.direction):
            yield Problem(here, f"Both ends of {delegation.name} must have one interface and direction.", "Correct it.")
    yield from _open_ports(model, ports, writers)


def _ends(given: Port | None, taken: Port | None, at: Pointer) -> Iterator[Problem]:
    if given is None or taken is None:
        yield Problem(at, "Both ends of a connector must be ports of components of the composition.", "Correct the names.")  # fmt: skip
    elif given.interface != taken.interface or given.direction != "Provided" or taken.direction != "Required":
        message = f"{taken.name} must be a required port of the interface of {given.name}, {given.interface}, which provides it."
        yield Problem(at, message, "Connect ports of one interface.")


def _open_ports(
    model: ClassicIntegration, ports: Mapping[tuple[str, str], Port], connected: Mapping[tuple[str, str], str]
) -> Iterator[Problem]:
    """Required ports that nothing is connected with; those of services are connected by the ECU configuration."""
    delegated = {(each.inner.component, each.inner.port) for each in model.composition.delegations}
    for key, port in ports.items():
        if port.direction == "Required" and not port.service and key not in connected and key not in delegated:
            message = f"{'.'.join(key)} must be connected, with a component or with a port of the composition."
            yield Problem(("Composition", "Assemblies"), message, "Add a connector.")


def task_problems(model: ClassicIntegration) -> Iterator[Problem]:
    """Every event has one task, or one batch that runs before; runnables that never run twice at a time have all theirs in one."""
    types = {each.name: each for each in model.components}
    events = {
        (each.name, event.name): event
        for each in model.composition.prototypes
        for event in (types[each.type].events if each.type in types else ())
    }
    mapped: dict[tuple[str, str], str] = {}
    homes: dict[tuple[str, str], str] = {}
    for at, entry, (place, position_of) in _mappings(model):
        key = (entry.component, entry.event)
        if key not in events:
            yield unknown(at, "event", ".".join(key))
            continue
        if key in mapped:
            message = f"{'.'.join(key)} must be in one task and once, and is in {mapped[key]} too."
            yield Problem(at, message, "Take it away.")
        mapped[key] = place
        if position_of.count(entry.position) > 1:
            message = f"Position {entry.position} of {place} must be that of one event."
            yield Problem((*at, "Position"), message, "Number them.")
        if "InitBatches" in at and events[key].kind != "Init":
            message = (
                f"{'.'.join(key)} must be an init event to be in {place}: nothing else comes before the tasks run."
            )
            yield Problem(at, message, "Map it to a task.")
        yield from _in_ticks(events[key], key, at, model)
        home = (entry.component, events[key].runnable)
        if homes.setdefault(home, place) != place:
            message = f"All events of {'.'.join(home)} must be in one task, since it never runs twice at a time; others are in {homes[home]}."
            yield Problem(at, message, "Move it there.")
    for key in events:
        if key not in mapped:
            yield Problem(("Ecu", "Tasks"), f"{'.'.join(key)} must be in a task.", "Map it to one.")


def signal_problems(model: ClassicIntegration, elements: Mapping[str, frozenset[str]]) -> Iterator[Problem]:
    """Signals of buses: each carries one data element of the composition, which has no other one."""
    interfaces = {port.name: port.interface for port in model.composition.ports}
    needs = needs_of(model)
    at: Pointer = ("Ecu", "Signals")
    carried: dict[tuple[str, str], str] = {}
    seen: dict[str, int] = {}
    for index, each in enumerate(model.ecu.signals):
        here = (*at, index)
        yield from name((*here, "SystemSignal"), each.signal)
        if seen.setdefault(each.signal.lower(), index) != index:
            yield Problem((*here, "SystemSignal"), f"{each.signal} must carry one data element, and carries two.", "Rename one.")  # fmt: skip
        if each.element not in elements.get(interfaces.get(each.port, ""), ()):
            yield unknown((*here, "Port"), f"port of the composition that has {each.element}", each.port)
        other = carried.setdefault((each.port, each.element), each.signal)
        if other != each.signal:
            yield Problem((*here, "Port"), f"{each.port} must have one signal, and has {other} already.", "Take one away.")  # fmt: skip
        need = needs.get((interfaces.get(each.port, ""), each.element))
        if each.length is not None and not 1 <= each.length <= LONGEST_SIGNAL:
            message = f"A signal must be 1 to {LONGEST_SIGNAL} bits long, not {each.length}."
            yield Problem((*here, "Length"), message, "Correct it.")
        elif need is not None and not need.fits(each.length, has_database=each.database is not None):
            message = f"{each.signal} must have at least {need.bits} bits for every value of {each.element}, not {each.length}."
            yield Problem((*here, "Length"), message, need.advice)


_Place = tuple[str, list[int]]
"""Name of a task or a batch, and the positions that it has given."""


def _mappings(model: ClassicIntegration) -> Iterator[tuple[Pointer, TaskEvent, _Place]]:
    """Every event that is mapped, where that stands, and to what."""
    for kind in ("InitBatches", "Tasks"):
        for at, place in places(model, f"Ecu/{kind}/*"):
            positions = [each.position for each in place.events]
            for here, entry in places(place, "Events/*", at):
                yield here, entry, (place.name, positions)


def _in_ticks(event: Event, key: tuple[str, str], at: Pointer, model: ClassicIntegration) -> Iterator[Problem]:
    """Periods and offsets that the counter can count."""
    for what, seconds in (("period", event.period), ("offset", event.offset)):
        ticks = (seconds or 0) * 1_000_000 / max(model.deployment.tick, 1)
        if not isfinite(ticks) or abs(ticks - round(ticks)) > 1e-6:
            message = (
                f"The {what} of {'.'.join(key)} must be whole ticks of {model.deployment.tick} µs, not {seconds} s."
            )
            yield Problem(at, message, "Choose a shorter tick in the deployment.")
