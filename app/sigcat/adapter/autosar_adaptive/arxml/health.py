"""The supervision by health management: alive supervisions with the same result there as in the core.

Its verdict is at once, and final until the process starts again. So an alive supervision agrees with that of the core if
no mode excludes its call, and if its error neither matures nor heals.
"""

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.arxml.tree import Package, Tag, listed, reference, references, seconds, tag
from sigcat.adapter.autosar_adaptive.arxml.adaptive_type_elements import Library
from sigcat.adapter.autosar_adaptive.arxml.components import (
    SUPERVISION_PORT,
    checkpoints,
    root_reference,
    supervision_name,
)
from sigcat.adapter.autosar_adaptive.arxml.paths import COMPONENTS, HEALTH, PROCESSES, SUPERVISIONS
from sigcat.function.function_json.runnable import WatchdogLimits
from sigcat.integration.autosar_adaptive.model import Call, Component
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

    call: Call
    limits: WatchdogLimits


def alive_supervisions(component: Component) -> tuple[AliveSupervision, ...]:
    """Return the alive supervisions of a component."""
    parts = (part for interface in component.services for part in interface.services)
    errors = {field.error.name: field.error for part in parts for field in part.fields if field.error is not None}
    final = {name for name, error in errors.items() if error.reset == _RESTART and not error.maturation_time}
    reported = checkpoints(component)
    return tuple(
        AliveSupervision(call, call.watchdog.alive)
        for call in component.calls
        if call.watchdog and call.watchdog.alive and call.cycle_time and call.name in reported
        if call.watchdog.alive.error_name in final
    )


def package(run: Sequence[Process], states: Mapping[str, Tag], known: Library) -> Package:
    """The package of supervisions; it is empty if there are none. `states` refer to those of the function group."""
    supervised = [process for process in run if alive_supervisions(process.component)]
    if not supervised:
        return Package(HEALTH, ())
    own = known.path(HEALTH, NAME)
    points = (point for process in supervised for point in _checkpoints(process, known))
    has_locals = known.release.has_local_supervisions
    parts = _with_locals(supervised, own) if has_locals else _with_modes(supervised, states, own)
    return Package(HEALTH, (tag(CONTRIBUTION, listed("CHECKPOINTS", points), *parts, name=NAME),))


def _supervisions_name(process: Process) -> str:
    return short_name(f"{process.stem}_Supervision")


# -- checkpoints --------------------------------------------------------------------------------------------------


def _point_name(call: str, process: Process) -> str:
    """Names of calls are unique; each further process has them again."""
    return short_name(f"{process.stem}_{call}_Checkpoint" if process.is_further else f"{call}_Checkpoint")


def _checkpoints(process: Process, known: Library) -> Iterable[Tag]:
    component = process.component
    port = known.path(COMPONENTS, component.name, SUPERVISION_PORT)
    numbers = {call: number for number, call in enumerate(checkpoints(component))}
    for call, _ in alive_supervisions(component):
        point = known.path(SUPERVISIONS, supervision_name(component), short_name(call.name))
        yield tag(
            _CHECKPOINT,
            {"CHECKPOINT-ID": numbers[call.name]},
            tag(
                "PHM-CHECKPOINT-IREF",
                root_reference(component, known),
                reference("CONTEXT-R-PORT-PROTOTYPE-REF", port, "R-PORT-PROTOTYPE"),
                reference("TARGET-PHM-CHECKPOINT-REF", point, "PHM-CHECKPOINT"),
            ),
            reference("PROCESS-REF", known.path(PROCESSES, process.name), "PROCESS"),
            name=_point_name(call.name, process),
        )


# -- supervisions -------------------------------------------------------------------------------------------------


def _with_modes(supervised: Sequence[Process], states: Mapping[str, Tag], own: str) -> Iterable[Tag]:
    """Supervisions that are active in states of the function group, as of R21-11."""
    conditions = (
        tag(
            "SUPERVISION-MODE-CONDITION",
            tag("STATE-REFERENCES", tag("FUNCTION-GROUP-PHM-STATE-REFERENCE", states[state])),
            name=_condition_name(state),
        )
        for state in dict.fromkeys(state for process in supervised for state in _states(process))
    )
    yield tag("SUPERVISION-MODE-CONDITIONS", *conditions)
    globals_ = (
        tag(
            "GLOBAL-SUPERVISION",
            _alives(process, own, _TOLERANCE),
            tag("SUPERVISION-MODES", *(_mode(state, process, own) for state in _states(process))),
            name=_supervisions_name(process),
        )
        for process in supervised
    )
    yield tag("GLOBAL-SUPERVISIONS", *globals_)


def _states(process: Process) -> Iterable[str]:
    """States of the function group in which supervised calls run."""
    return dict.fromkeys(state for each in alive_supervisions(process.component) for state in each.call.modes)


def _condition_name(state: str) -> str:
    return short_name(f"In{state}")


def _mode(state: str, process: Process, own: str) -> Tag:
    name, alive = _supervisions_name(process), alive_supervisions(process.component)
    paths = (f"{own}/{name}/{_alive_name(each.call)}" for each in alive if state in each.call.modes)
    return tag(
        "SUPERVISION-MODE",
        references("ACTIVE-SUPERVISION-REF", paths, "ALIVE-SUPERVISION"),
        {"EXPIRED-SUPERVISION-TOLERANCE": _TOLERANCE},
        reference("MODE-CONDITION-REF", f"{own}/{_condition_name(state)}", "SUPERVISION-MODE-CONDITION"),
        name=short_name(f"{name}_{state}"),
    )


def _with_locals(supervised: Sequence[Process], own: str) -> Iterable[Tag]:
    """Local supervisions, and a global one of each, as R20-11 has them."""
    tolerance = {"FAILED-SUPERVISION-CYCLES-TOLERANCE": _TOLERANCE}
    locals_ = (
        tag("LOCAL-SUPERVISION", _alives(process, own, None), tolerance, name=_supervisions_name(process))
        for process in supervised
    )
    yield tag("LOCAL-SUPERVISIONS", *locals_)
    globals_ = (
        tag(
            "GLOBAL-SUPERVISION",
            {"EXPIRED-SUPERVISION-CYCLES-TOLERANCE": _TOLERANCE},
            references("LOCAL-SUPERVISION-REF", [f"{own}/{name}"], "LOCAL-SUPERVISION"),
            name=short_name(f"{name}_Global"),
        )
        for name in map(_supervisions_name, supervised)
    )
    yield tag("GLOBAL-SUPERVISIONS", *globals_)


def _alive_name(call: Call) -> str:
    return short_name(f"{call.name}_Alive")


def _alives(process: Process, own: str, tolerance: int | None) -> Tag:
    alive = alive_supervisions(process.component)
    return tag("ALIVE-SUPERVISIONS", *(_alive(each, process, own, tolerance) for each in alive))


def _alive(each: AliveSupervision, process: Process, own: str, tolerance: int | None) -> Tag:
    """As many indications in a window as expected, less or more by a margin."""
    expected, least, most = (int(number) for number in (each.limits.reference, each.limits.min, each.limits.max))
    return tag(
        "ALIVE-SUPERVISION",
        {"ALIVE-REFERENCE-CYCLE": seconds(each.limits.reference * (each.call.cycle_time or 0))},
        reference("CHECKPOINT-REF", f"{own}/{_point_name(each.call.name, process)}", _CHECKPOINT),
        {"EXPECTED-ALIVE-INDICATIONS": expected, "FAILED-REFERENCE-CYCLES-TOLERANCE": tolerance},
        {"MAX-MARGIN": max(most - expected, 0), "MIN-MARGIN": max(expected - least, 0)},
        name=_alive_name(each.call),
    )
