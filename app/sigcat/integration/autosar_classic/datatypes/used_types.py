"""Enumerations that a component exchanges, whose names its code has."""

from collections.abc import Iterable, Mapping
from typing import TypeVar

from sigcat.integration.autosar_classic.model import (
    ApplicationType,
    ClassicIntegration,
    Component,
    ImplementationType,
    ParameterInterface,
    SenderReceiverInterface,
)

T = TypeVar("T", ApplicationType, ImplementationType)


def element_types(model: ClassicIntegration) -> dict[tuple[str, str], str]:
    """Type of each data element and parameter, by interface and name."""
    interfaces: tuple[SenderReceiverInterface | ParameterInterface, ...] = (
        *model.sender_receiver_interfaces,
        *model.parameter_interfaces,
    )
    return {(each.name, element.name): element.type for each in interfaces for element in each.elements}


def exchanged_types(model: ClassicIntegration) -> dict[str, tuple[str, ...]]:
    """Types of everything that an interface has: of elements, of arguments, of its mode."""
    found: dict[str, tuple[str, ...]] = {}
    for (interface, _), type_name in element_types(model).items():
        found[interface] = (*found.get(interface, ()), type_name)
    for calls in model.client_server_interfaces:
        found[calls.name] = tuple(each.type for operation in calls.operations for each in operation.arguments)
    groups = {group.name: group.type for group in model.mode_groups}
    for modes in model.mode_switch_interfaces:
        found[modes.name] = (groups.get(modes.group, ""),)
    return found


def with_inner(names: Iterable[str], known: Mapping[str, T]) -> list[T]:
    """The types of these names, and those within arrays and structs, by name."""
    left: list[str] = [*names]
    found: dict[str, T] = {}
    while left:
        name: str = left.pop()
        if name in known and name not in found:
            found[name] = known[name]
            left += [known[name].element or "", *(member.type for member in known[name].members or ())]
    return [found[name] for name in sorted(found)]


def enumerations_of(
    component: Component,
    exchanged: Mapping[str, tuple[str, ...]],
    application_types: Mapping[str, ApplicationType],
    implementation_types: Mapping[str, ImplementationType],
) -> tuple[ImplementationType, ...]:
    """Return enumerations at its ports and of its parameters, and those within arrays and structs, by name."""
    names = [name for port in component.ports for name in exchanged.get(port.interface, ())]
    names += [parameter.type for parameter in component.parameters]
    left = [application_types[name].implementation if name in application_types else name for name in names]
    return tuple(each for each in with_inner(left, implementation_types) if each.compu_method)
