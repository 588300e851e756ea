"""The supervision by health management: alive supervisions with the same result there as in the core.

Its verdict is at once, and final until the process starts again. So an alive supervision agrees with that of the core if
no mode excludes its call, and if its error neither matures nor heals.
"""

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.arxml.paths import Paths
from sigcat.adapter.arxml.tree import Package, Tag, listed, reference, seconds, tag
from sigcat.adapter.autosar_adaptive.arxml.components import (
    SUPERVISION_PORT,
    checkpoints,
    root_name,
    supervision_name,
)
from sigcat.adapter.autosar_adaptive.arxml.paths import COMPONENTS, EXECUTABLES, HEALTH, PROCESSES, SUPERVISIONS
from sigcat.adapter.autosar_adaptive.arxml.releases import Release
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface
from sigcat.function.function_json.runnable import WatchdogLimits
from sigcat.integration.autosar_adaptive.model import Call, Component, ServiceField
from sigcat.integration.autosar_adaptive.processes import Process
from sigcat.integration.autosar_names import short_name

CONTRIBUTION = "PLATFORM-HEALTH-MANAGEMENT-CONTRIBUTION"
NAME = "Supervisions"
_RESTART = "Restart"
_CHECKPOINT = "SUPERVISION-CHECKPOINT"
_TOLERANCE = 0
"""Windows that may be bad before the verdict is final: none."""


class AliveSupervision(NamedTuple):
    """An alive supervision that agrees with that of the core."""

    call: str
    expected: int
    """Indications in a window."""
    window: float
    """In ms."""
    least: int
    most: int
    states: tuple[str, ...]
    """States of the function group in which the call runs."""


def alive_supervisions(component: Component) -> tuple[AliveSupervision, ...]:
    """Return the alive supervisions of a component."""
    errors = {field.error.name: field.error for field in _fields(component) if field.error is not None}
    reported = [call for call in component.calls if call.name in checkpoints(component)]
    pairs = ((call, call.watchdog.alive) for call in reported if call.watchdog)
    return tuple(
        _supervision(call, limits)
        for call, limits in pairs
        if limits and call.cycle_time and _is_final(errors.get(limits.error_name))
    )


def _fields(component: Component) -> list[ServiceField]:
    return [field for interface in component.services for part in interface.services for field in part.fields]


def _is_final(error: ErrorInterface | None) -> bool:
    return error is not None and error.reset == _RESTART and not error.maturation_time


def _supervision(call: Call, limits: WatchdogLimits) -> AliveSupervision:
    expected = int(limits.reference)
    window = limits.reference * (call.cycle_time or 0)
    return AliveSupervision(call.name, expected, window, int(limits.min), int(limits.max), call.modes)


def package(run: Sequence[Process], states: Mapping[str, Tag], release: Release, paths: Paths) -> Package:
    """The package of supervisions; it is empty if there are none. `states` refer to those of the function group."""
    supervised = [process for process in run if alive_supervisions(process.component)]
    if not supervised:
        return Package(HEALTH, ())
    own = paths.of(HEALTH, NAME)
    points = [point for process in supervised for point in _checkpoints(process, paths)]
    each = [
        _Supervised(_supervisions_name(process), process, alive_supervisions(process.component))
        for process in supervised
    ]
    parts = _with_locals(each, own) if release.has_local_supervisions else _with_modes(each, states, own)
    return Package(HEALTH, (tag(CONTRIBUTION, listed("CHECKPOINTS", points), *parts, name=NAME),))


def _supervisions_name(process: Process) -> str:
    return short_name(f"{process.stem}_Supervision")


# -- checkpoints --------------------------------------------------------------------------------------------------


def _point_name(call: str, process: Process) -> str:
    """Names of calls are unique; each further process has them again."""
    return short_name(f"{process.stem}_{call}_Checkpoint" if process.is_further else f"{call}_Checkpoint")


def _checkpoints(process: Process, paths: Paths) -> Iterable[Tag]:
    component = process.component
    root = paths.of(EXECUTABLES, component.executable, root_name(component))
    port = paths.of(COMPONENTS, component.name, SUPERVISION_PORT)
    numbers = {call: number for number, call in enumerate(checkpoints(component))}
    for each in alive_supervisions(component):
        point = paths.of(SUPERVISIONS, supervision_name(component), short_name(each.call))
        yield tag(
            _CHECKPOINT,
            tag("CHECKPOINT-ID", text=numbers[each.call]),
            tag(
                "PHM-CHECKPOINT-IREF",
                reference("CONTEXT-ROOT-SW-COMPONENT-PROTOTYPE-REF", root, "ROOT-SW-COMPONENT-PROTOTYPE"),
                reference("CONTEXT-R-PORT-PROTOTYPE-REF", port, "R-PORT-PROTOTYPE"),
                reference("TARGET-PHM-CHECKPOINT-REF", point, "PHM-CHECKPOINT"),
            ),
            reference("PROCESS-REF", paths.of(PROCESSES, process.name), "PROCESS"),
            name=_point_name(each.call, process),
        )


# -- supervisions -------------------------------------------------------------------------------------------------


class _Supervised(NamedTuple):
    """The supervisions of a process."""

    name: str
    process: Process
    alive: Sequence[AliveSupervision]


def _with_modes(supervised: Sequence[_Supervised], states: Mapping[str, Tag], own: str) -> Iterable[Tag]:
    """Supervisions that are active in states of the function group, as of R21-11."""
    named = dict.fromkeys(state for part in supervised for each in part.alive for state in each.states)
    conditions = (
        tag(
            "SUPERVISION-MODE-CONDITION",
            tag("STATE-REFERENCES", tag("FUNCTION-GROUP-PHM-STATE-REFERENCE", states[state])),
            name=_condition_name(state),
        )
        for state in named
    )
    yield tag("SUPERVISION-MODE-CONDITIONS", *conditions)
    globals_ = (
        tag(
            "GLOBAL-SUPERVISION",
            tag("ALIVE-SUPERVISIONS", *(_alive(each, part.process, own, has_tolerance=True) for each in part.alive)),
            tag("SUPERVISION-MODES", *_modes(part.name, part.alive, own)),
            name=part.name,
        )
        for part in supervised
    )
    yield tag("GLOBAL-SUPERVISIONS", *globals_)


def _condition_name(state: str) -> str:
    return short_name(f"In{state}")


def _modes(name: str, alive: Sequence[AliveSupervision], own: str) -> Iterable[Tag]:
    for state in dict.fromkeys(state for each in alive for state in each.states):
        paths = (f"{own}/{name}/{_alive_name(each.call)}" for each in alive if state in each.states)
        active = (reference("ACTIVE-SUPERVISION-REF", path, "ALIVE-SUPERVISION") for path in paths)
        condition = f"{own}/{_condition_name(state)}"
        yield tag(
            "SUPERVISION-MODE",
            tag("ACTIVE-SUPERVISION-REFS", *active),
            tag("EXPIRED-SUPERVISION-TOLERANCE", text=_TOLERANCE),
            reference("MODE-CONDITION-REF", condition, "SUPERVISION-MODE-CONDITION"),
            name=short_name(f"{name}_{state}"),
        )


def _with_locals(supervised: Sequence[_Supervised], own: str) -> Iterable[Tag]:
    """Local supervisions, and a global one of each, as R20-11 has them."""
    locals_ = (
        tag(
            "LOCAL-SUPERVISION",
            tag("ALIVE-SUPERVISIONS", *(_alive(each, part.process, own, has_tolerance=False) for each in part.alive)),
            tag("FAILED-SUPERVISION-CYCLES-TOLERANCE", text=_TOLERANCE),
            name=part.name,
        )
        for part in supervised
    )
    yield tag("LOCAL-SUPERVISIONS", *locals_)
    globals_ = (
        tag(
            "GLOBAL-SUPERVISION",
            tag("EXPIRED-SUPERVISION-CYCLES-TOLERANCE", text=_TOLERANCE),
            tag(
                "LOCAL-SUPERVISION-REFS", reference("LOCAL-SUPERVISION-REF", f"{own}/{part.name}", "LOCAL-SUPERVISION")
            ),
            name=short_name(f"{part.name}_Global"),
        )
        for part in supervised
    )
    yield tag("GLOBAL-SUPERVISIONS", *globals_)


def _alive_name(call: str) -> str:
    return short_name(f"{call}_Alive")


def _alive(each: AliveSupervision, process: Process, own: str, *, has_tolerance: bool) -> Tag:
    """As many indications in a window as expected, less or more by a margin."""
    return tag(
        "ALIVE-SUPERVISION",
        tag("ALIVE-REFERENCE-CYCLE", text=seconds(each.window)),
        reference("CHECKPOINT-REF", f"{own}/{_point_name(each.call, process)}", _CHECKPOINT),
        tag("EXPECTED-ALIVE-INDICATIONS", text=each.expected),
        tag("FAILED-REFERENCE-CYCLES-TOLERANCE", text=_TOLERANCE) if has_tolerance else None,
        tag("MAX-MARGIN", text=max(each.most - each.expected, 0)),
        tag("MIN-MARGIN", text=max(each.expected - each.least, 0)),
        name=_alive_name(each.call),
    )
