"""The components together: who is connected with whom, and what is open to the outside."""

from collections.abc import Mapping, Sequence
from typing import Any

from sigcat.function.document.text import Text
from sigcat.integration.autosar_classic import model
from sigcat.integration.autosar_classic.context import Context
from sigcat.integration.autosar_classic.elements import Element
from sigcat.integration.autosar_names import distinct, distinct_names, short_name
from sigcat.integration.grouping import grouped


def composition_of(
    components: Sequence[model.Component],
    parameter_components: Sequence[model.ParameterComponent],
    elements: Sequence[Element],
    context: Context,
) -> model.Composition:
    """The composition of all components. Service ports are connected by the ECU configuration, and not here."""
    types: tuple[_Type, ...] = (*components, *parameter_components)
    ports = _by_interface(types)
    assemblies, delegations, outer = [], [], []
    outside = _providers_outside(elements, context)
    borders = distinct({interface: interface for interface in ports}, (each.name for each in types))
    for interface, sides in ports.items():
        provided = [side for side in sides if side[1].direction == "Provided"]
        required = [side for side in sides if side[1].direction == "Required"]
        told = [side for side in provided if _is_reaction(side[1])]
        assemblies += [_assembly(provided[0], side) for side in required if provided and not told]
        if required and (told or not provided):
            outer.append(_outer(borders[interface], required[0][1], outside.get(interface)))
            delegations += [_delegation(side, borders[interface]) for side in required]
        for side in told or (provided[:1] if not required else []):
            name = short_name(f"{side[0]}_{side[1].name}") if told else borders[interface]
            outer.append(_outer(name, side[1], None))
            delegations.append(_delegation(side, name))
    taken = [*(each.name for each in types), *(each.name for each in outer)]
    return model.Composition(
        name=short_name(f"{context.application.name}Composition"),
        prototypes=tuple(model.Prototype(name=each.name, type=each.name) for each in types),
        ports=tuple(outer),
        assemblies=_with_names(assemblies, taken),
        delegations=_with_names(delegations, taken),
    )


_Type = model.Component | model.ParameterComponent
_Side = tuple[str, model.Port]


def _is_reaction(port: model.Port) -> bool:
    """Whether it tells a safety condition, which no other component of the set hears: the outside decides that alone."""
    return any(use.kind == "safety reaction" for element in port.elements for use in element.uses or ())


def _by_interface(types: Sequence[_Type]) -> Mapping[str, list[_Side]]:
    sides = ((component.name, port) for component in types for port in component.ports if not port.service)
    return dict(sorted(grouped(sides, lambda side: side[1].interface).items()))


def _providers_outside(elements: Sequence[Element], context: Context) -> Mapping[str, Text]:
    """Return the providers outside by interface, as the functions or the deployment name them."""
    app = context.application
    managers = {"reaction": app.safety_manager, "mode in": app.mode_manager}
    found: dict[str, Text] = {}
    for element in elements:
        named = [getattr(side.interface, "external_provider", None) for side in element.sides]
        provider = next(filter(None, named), None) or managers.get(element.kind)
        if provider:
            found[element.name] = provider
    return found


def _assembly(provider: _Side, requester: _Side) -> model.Assembly:
    return model.Assembly(
        name=short_name(f"{provider[0]}_{provider[1].name}_{requester[0]}"),
        provider=model.PortReference(component=provider[0], port=provider[1].name),
        requester=model.PortReference(component=requester[0], port=requester[1].name),
    )


def _delegation(side: _Side, outer: str) -> model.Delegation:
    return model.Delegation(
        name=short_name(f"{side[0]}_{side[1].name}"),
        inner=model.PortReference(component=side[0], port=side[1].name),
        outer=outer,
    )


def _outer(name: str, port: model.Port, provider: Text | None) -> model.OuterPort:
    is_data = port.kind == "SenderReceiver" and port.elements[0].queue_length is None
    return model.OuterPort(
        name=name,
        direction=port.direction,
        kind=port.kind,
        interface=port.interface,
        init=port.elements[0].init if is_data else None,
        provider=provider if port.direction == "Required" else None,
    )


def _with_names(connectors: Sequence[Any], taken: list[str]) -> tuple[Any, ...]:
    """Connectors under names that no other element of the composition has."""
    names = distinct_names([each.name for each in connectors], taken)
    taken.extend(names)
    return tuple(each.model_copy(update={"name": name}) for each, name in zip(connectors, names, strict=True))
