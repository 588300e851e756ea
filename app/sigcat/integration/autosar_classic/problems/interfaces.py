"""Port interfaces and modes that an RTE generator would refuse: doubled names, missing types and modes."""

from collections.abc import Iterator

from sigcat.function.document.document import Pointer
from sigcat.integration.autosar_classic.datatypes.platform_types import WHOLE_NUMBERS
from sigcat.integration.autosar_classic.model import (
    ClassicIntegration,
    Component,
    ModeGroup,
)
from sigcat.integration.problem import Problem
from sigcat.integration.references import places, unknown

_MODE_TYPES = ("uint8", "uint16", "uint32")


def interface_problems(model: ClassicIntegration) -> Iterator[Problem]:
    """Numbers of errors and modes, and events of modes."""
    bases = {each.name: each.base or each.name for each in model.implementation_types}
    for at, number in places(model, "ClientServerInterfaces/*/ApplicationErrors/*/Value"):
        if not 1 <= number <= 63:
            message = f"The number of an application error must be from 1 to 63, not {number}."
            yield Problem(at, message, "Correct it.")
    for index, group in enumerate(model.mode_groups):
        yield from _modes(group, ("ModeGroups", index), bases.get(group.type, group.type))
    for index, component in enumerate(model.components):
        yield from _mode_events(component, ("Components", index), model)


def _modes(group: ModeGroup, at: Pointer, base: str) -> Iterator[Problem]:
    """Modes with distinct numbers, which the type of the group holds; the transition has one that no mode has."""
    if base not in _MODE_TYPES:
        yield unknown((*at, "Type"), f"type that is {', '.join(_MODE_TYPES)}", group.type)
        return
    _, largest = WHOLE_NUMBERS[base]
    places: list[tuple[Pointer, int]] = [((*at, "Modes", i, "Value"), mode.value) for i, mode in enumerate(group.modes)]
    places.append(((*at, "OnTransitionValue"), group.on_transition))
    seen: set[int] = set()
    for where, number in places:
        if not 0 <= number <= largest:
            yield Problem(where, f"The number of a mode must be from 0 to {largest}, not {number}.", "Correct it.")
        if number in seen:
            message = f"{number} must be the number of one mode, or of the transition, and is that of two."
            yield Problem(where, message, "Take another number.")
        seen.add(number)


def _mode_events(component: Component, at: Pointer, model: ClassicIntegration) -> Iterator[Problem]:
    groups = {group.name: [mode.name for mode in group.modes] for group in model.mode_groups}
    of_interface = {each.name: groups.get(each.group, []) for each in model.mode_switch_interfaces}
    of_port = {port.name: of_interface.get(port.interface, []) for port in component.ports}
    for index, event in enumerate(component.events):
        if event.kind == "ModeSwitch" and event.mode not in of_port.get(event.port or "", []):
            yield unknown((*at, "Events", index, "Mode"), f"mode of {event.port}", str(event.mode))
