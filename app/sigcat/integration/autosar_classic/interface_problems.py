"""Port interfaces and modes that an RTE generator would refuse: doubled names, missing types and modes."""

from collections.abc import Iterator

from sigcat.function.document.document import Pointer
from sigcat.integration.autosar_classic.model import (
    ClassicIntegration,
    ClientServerInterface,
    Component,
    ModeGroup,
    Operation,
    ParameterInterface,
    SenderReceiverInterface,
)
from sigcat.integration.autosar_classic.platform_types import WHOLE_NUMBERS
from sigcat.integration.autosar_classic.problem import names, unknown
from sigcat.integration.checked_document import Problem

_MODE_TYPES = ("uint8", "uint16", "uint32")


def interface_problems(model: ClassicIntegration) -> Iterator[Problem]:
    """Elements, operations and modes of interfaces, and events of modes."""
    types = {each.name for each in model.implementation_types}
    bases = {each.name: each.base or each.name for each in model.implementation_types}
    meanings = types | {each.name for each in model.application_types}
    for index, data in enumerate(model.sender_receiver_interfaces):
        yield from _elements(data, ("SenderReceiverInterfaces", index), meanings)
    for index, parameters in enumerate(model.parameter_interfaces):
        yield from _elements(parameters, ("ParameterInterfaces", index), meanings)
    for index, calls in enumerate(model.client_server_interfaces):
        yield from _operations(calls, ("ClientServerInterfaces", index), types)
    for index, group in enumerate(model.mode_groups):
        yield from _modes(group, ("ModeGroups", index), bases.get(group.type, group.type))
    for index, component in enumerate(model.components):
        yield from _mode_events(component, ("Components", index), model)


def _elements(interface: SenderReceiverInterface | ParameterInterface, at: Pointer, types: set[str]) -> Iterator[Problem]:  # fmt: skip
    yield from names((*at, "Elements"), (each.name for each in interface.elements))
    for index, element in enumerate(interface.elements):
        if element.type not in types:
            yield unknown((*at, "Elements", index, "Type"), "datatype", element.type)


def _operations(interface: ClientServerInterface, at: Pointer, types: set[str]) -> Iterator[Problem]:
    errors = [each.name for each in interface.errors or ()]
    yield from names((*at, "Operations"), (each.name for each in interface.operations))
    yield from names((*at, "ApplicationErrors"), errors)
    for index, error in enumerate(interface.errors or ()):
        if not 1 <= error.value <= 63:
            message = f"The number of an application error must be from 1 to 63, not {error.value}."
            yield Problem((*at, "ApplicationErrors", index, "Value"), message, "Correct it.")
    for index, operation in enumerate(interface.operations):
        yield from _operation(operation, (*at, "Operations", index), types, errors)


def _operation(operation: Operation, at: Pointer, types: set[str], errors: list[str]) -> Iterator[Problem]:
    yield from names((*at, "Arguments"), (each.name for each in operation.arguments))
    for index, argument in enumerate(operation.arguments):
        if argument.type not in types:
            yield unknown((*at, "Arguments", index, "Type"), "implementation type", argument.type)
    for index, error in enumerate(operation.errors or ()):
        if error not in errors:
            yield unknown((*at, "PossibleErrors", index), "application error of the interface", error)


def _modes(group: ModeGroup, at: Pointer, base: str) -> Iterator[Problem]:
    """Modes with distinct numbers, which the type of the group holds; the transition has one that no mode has."""
    yield from names((*at, "Modes"), (mode.name for mode in group.modes))
    if group.initial not in [mode.name for mode in group.modes]:
        yield unknown((*at, "InitialMode"), "mode of the group", group.initial)
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
