"""Service needs that the base software would refuse: memory, diagnosis, inhibition, supervision."""

from collections.abc import Iterator, Mapping

from sigcat.function.document.document import Pointer
from sigcat.integration.autosar_classic.model import (
    AliveSupervision,
    ClassicIntegration,
    Component,
    DeadlineSupervision,
    DiagnosticEvent,
    Port,
    SupervisedEntity,
)
from sigcat.integration.checked_document import Problem
from sigcat.integration.references import unknown

_LARGEST = {"byte": 255, "word": 65_535}
"""Largest values of counters of the base software."""


def need_problems(model: ClassicIntegration) -> Iterator[Problem]:
    """Needs of all components: ports that lead to the right module, existing elements, numbers that it takes."""
    errors = _reported(model)
    for index, component in enumerate(model.components):
        yield from _of_component(component, ("Components", index), errors)


def _reported(model: ClassicIntegration) -> frozenset[str]:
    """Errors of the components, and those of others whose status they receive."""
    own = (event.error for component in model.components for event in component.diagnostic_events)
    uses = (
        use
        for component in model.components
        for port in component.ports
        for element in port.elements
        for use in element.uses or ()
    )
    return frozenset((*own, *(use.interface for use in uses if use.kind == "error")))


def _of_component(component: Component, at: Pointer, errors: frozenset[str]) -> Iterator[Problem]:
    ports = {port.name: port for port in component.ports}
    for index, block in enumerate(component.nv_blocks):
        yield from _service_port(block.port, "NvRamManager", (*at, "NvBlocks", index, "Port"), ports)
    for index, event in enumerate(component.diagnostic_events):
        yield from _event(event, (*at, "DiagnosticEvents", index), ports)
    for index, entity in enumerate(component.supervised_entities):
        yield from _entity(entity, (*at, "SupervisedEntities", index), ports, errors)
    for index, inhibition in enumerate(component.inhibitions):
        for number, error in enumerate(inhibition.events):
            if error not in errors:
                here: Pointer = (*at, "Inhibitions", index, "Events", number)
                yield unknown(here, "error, of a component or a port", error)


def _event(event: DiagnosticEvent, at: Pointer, ports: Mapping[str, Port]) -> Iterator[Problem]:
    yield from _service_port(event.port, "DiagnosticEventManager", (*at, "Port"), ports)
    yield from _count(event.occurrence_limit, "byte", (*at, "OccurrenceCountLimit"))
    yield from _count(event.ignition_limit, "byte", (*at, "IgnitionCountLimit"))


def _service_port(name: str, service: str, at: Pointer, ports: Mapping[str, Port]) -> Iterator[Problem]:
    """The port through which a module of the base software is reached."""
    port = ports.get(name)
    if port is None or port.service != service or port.direction != "Required" or not port.elements:
        yield unknown(at, f"port that requires an operation of the {service}", name)


def _entity(
    entity: SupervisedEntity, at: Pointer, ports: Mapping[str, Port], errors: frozenset[str]
) -> Iterator[Problem]:
    yield from _numbers(entity, at)
    for index, point in enumerate(entity.checkpoints):
        yield from _service_port(point.port, "WatchdogManager", (*at, "Checkpoints", index, "Port"), ports)
    for index, alive in enumerate(entity.alive):
        here: Pointer = (*at, "Alive", index)
        yield from _error(alive.error, errors, here)
        yield from _alive(alive, here)
    for index, deadline in enumerate(entity.deadlines):
        here = (*at, "Deadline", index)
        yield from _error(deadline.error, errors, here)
        yield from _deadline(deadline, here)


def _numbers(entity: SupervisedEntity, at: Pointer) -> Iterator[Problem]:
    seen: set[int] = set()
    for index, point in enumerate(entity.checkpoints):
        here: Pointer = (*at, "Checkpoints", index, "Number")
        yield from _count(point.number, "word", here)
        if point.number in seen:
            yield Problem(here, f"{point.number} must be the number of one checkpoint, and is that of two.", "Number them.")  # fmt: skip
        seen.add(point.number)


def _error(name: str, errors: frozenset[str], at: Pointer) -> Iterator[Problem]:
    if name and name not in errors:
        yield unknown((*at, "Error"), "error, of a component or a port", name)


def _alive(alive: AliveSupervision, at: Pointer) -> Iterator[Problem]:
    if alive.expected < 1:
        yield Problem((*at, "ExpectedIndications"), f"At least 1 indication must be expected, not {alive.expected}.", "Correct it.")  # fmt: skip
    yield from _count(alive.expected, "word", (*at, "ExpectedIndications"))
    yield from _count(alive.min_margin, "byte", (*at, "MinMargin"))
    yield from _count(alive.max_margin, "byte", (*at, "MaxMargin"))
    if alive.min_margin > alive.expected >= 1:
        message = f"No more than the {alive.expected} expected indications may be missing, not {alive.min_margin}."
        yield Problem((*at, "MinMargin"), message, "Correct one of the two.")
    if alive.reference_cycle <= 0:
        message = f"A reference cycle must be longer than 0 s, not {alive.reference_cycle}."
        yield Problem((*at, "ReferenceCycle"), message, "Correct it.")


def _deadline(deadline: DeadlineSupervision, at: Pointer) -> Iterator[Problem]:
    if deadline.start == deadline.end:
        yield Problem((*at, "End"), f"A deadline must end at another checkpoint than {deadline.start}.", "Correct it.")
    if not 0 <= deadline.min <= deadline.max:
        message = f"The shortest time must be from 0 to the longest, {deadline.max} s, not {deadline.min} s."
        yield Problem((*at, "Min"), message, "Correct one of the two.")


def _count(number: int | None, size: str, at: Pointer) -> Iterator[Problem]:
    if number is not None and not 0 <= number <= _LARGEST[size]:
        message = f"It must be from 0 to {_LARGEST[size]:,}, which the base software holds in a {size}, not {number}."
        yield Problem(at, message, "Correct it.")
