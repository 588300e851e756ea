"""Enumerations that a component exchanges, whose names its code has."""

from collections.abc import Mapping

from sigcat.integration.autosar_classic.model import (
    ApplicationType,
    ClassicIntegration,
    Component,
    ImplementationType,
    ParameterInterface,
    SenderReceiverInterface,
)


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
    found: dict[str, ImplementationType] = {}
    while left:
        each = implementation_types.get(left.pop())
        if each is not None and each.name not in found:
            found[each.name] = each
            left += [each.element or "", *(member.type for member in each.members or ())]
    return tuple(found[name] for name in sorted(found) if found[name].compu_method)
