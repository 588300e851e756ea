"""Service needs that the base software would refuse: memory, diagnosis, inhibition, supervision."""

from collections.abc import Iterator

from sigcat.function.document.document import Pointer
from sigcat.integration.autosar_classic.model import (
    AliveSupervision,
    ClassicIntegration,
    DeadlineSupervision,
    SupervisedEntity,
)
from sigcat.integration.problem import Problem
from sigcat.integration.references import places, unknown

_ENTITIES = "Components/*/SupervisedEntities/*"
_SERVICE_PORTS = {
    "Components/*/NvBlocks/*/Port": "NvRamManager",
    "Components/*/DiagnosticEvents/*/Port": "DiagnosticEventManager",
    f"{_ENTITIES}/Checkpoints/*/Port": "WatchdogManager",
}
"""Ports that lead to a module of the base software."""
_ERRORS = ("Components/*/Inhibitions/*/Events/*", f"{_ENTITIES}/Alive/*/Error", f"{_ENTITIES}/Deadline/*/Error")
"""Errors of components, or of others whose status they receive."""
_BYTE, _WORD = (255, "byte"), (65_535, "word")
_COUNTS = {
    "Components/*/DiagnosticEvents/*/OccurrenceCountLimit": _BYTE,
    "Components/*/DiagnosticEvents/*/IgnitionCountLimit": _BYTE,
    f"{_ENTITIES}/Checkpoints/*/Number": _WORD,
    f"{_ENTITIES}/Alive/*/ExpectedIndications": _WORD,
    f"{_ENTITIES}/Alive/*/MinMargin": _BYTE,
    f"{_ENTITIES}/Alive/*/MaxMargin": _BYTE,
}
"""Counters of the base software, with their largest values."""


def need_problems(model: ClassicIntegration) -> Iterator[Problem]:
    """Needs of all components: ports that lead to the right module, existing elements, numbers that it takes."""
    yield from _ports(model)
    uses = (use for _, use in places(model, "Components/*/Ports/*/Elements/*/Uses/*"))
    own = (error for _, error in places(model, "Components/*/DiagnosticEvents/*/Error"))
    errors = {*own, *(use.interface for use in uses if use.kind == "error")}
    for path in _ERRORS:
        for at, error in places(model, path):
            if error and error not in errors:
                yield unknown(at, "error, of a component or a port", error, errors)
    for path, (largest, size) in _COUNTS.items():
        for at, number in places(model, path):
            if not 0 <= number <= largest:
                message = f"It must be from 0 to {largest:,}, which the base software holds in a {size}, not {number}."
                yield Problem(at, message, "Correct it.")
    for at, entity in places(model, _ENTITIES):
        yield from _numbers(entity, at)
    for at, alive in places(model, f"{_ENTITIES}/Alive/*"):
        yield from _alive(alive, at)
    for at, deadline in places(model, f"{_ENTITIES}/Deadline/*"):
        yield from _deadline(deadline, at)


def _ports(model: ClassicIntegration) -> Iterator[Problem]:
    """Ports of services, each of which requires an operation of its module."""
    ports = [{port.name: port for port in component.ports} for component in model.components]
    for path, service in _SERVICE_PORTS.items():
        for at, name in places(model, path):
            port = ports[int(at[1])].get(name)
            if port is None or port.service != service or port.direction != "Required" or not port.elements:
                yield unknown(at, f"port that requires an operation of the {service}", name)


def _numbers(entity: SupervisedEntity, at: Pointer) -> Iterator[Problem]:
    seen: set[int] = set()
    for index, point in enumerate(entity.checkpoints):
        if point.number in seen:
            message = f"{point.number} must be the number of one checkpoint, and is that of two."
            yield Problem((*at, "Checkpoints", index, "Number"), message, "Number them.")
        seen.add(point.number)


def _alive(alive: AliveSupervision, at: Pointer) -> Iterator[Problem]:
    if alive.expected < 1:
        yield Problem((*at, "ExpectedIndications"), f"At least 1 indication must be expected, not {alive.expected}.", "Correct it.")  # fmt: skip
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
