"""Events, methods and fields of each service: named, typed, with ids, and with every side that takes part."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import NamedTuple

from sigcat import codes
from sigcat.function.exchange import Element as Exchanged
from sigcat.function.exchange import Kind, Side
from sigcat.function.function_json.duration import time_in_a_name
from sigcat.integration.autosar_adaptive.context import Context
from sigcat.integration.autosar_adaptive.deployment import identifiers
from sigcat.integration.autosar_adaptive.deployment.transport import DEFAULT_TRANSPORT, TransportSettings
from sigcat.integration.autosar_adaptive.e2e import E2eProtection
from sigcat.integration.autosar_adaptive.services.grouping import Group, group_of, report_rivals
from sigcat.integration.autosar_adaptive.someip.numbering import Names, numbers
from sigcat.integration.autosar_names import distinct, event_name, short_name
from sigcat.integration.finding_collector import Subject
from sigcat.integration.grouping import grouped

FIELD_GROUP = "Fields"
"""Event group of the notifiers of fields."""
EVENT_GROUP = "Events"
"""Event group of the events whose cycle is not known."""


@dataclass(frozen=True)
class Element(Exchanged):
    """An event, a method or a field: the sides of an element of the exchange that take part in one service."""

    name: str

    @property
    def is_event(self) -> bool:
        """Whether it is an event: data, queued or not."""
        return self.kind == "data"

    @property
    def is_method(self) -> bool:
        """Whether it is a method."""
        return self.kind == "method"

    @property
    def is_field(self) -> bool:
        """Whether it is a field: a status or a mode."""
        return not (self.is_event or self.is_method)


class Service(NamedTuple):
    """A service with all that it has, and the ids."""

    group: Group
    name: str
    id: int
    instance: int
    elements: tuple[Element, ...]
    ids: dict[str, int]
    """Ids of events and methods by name, of notifiers by the field's name, of getters by `Get<field>`."""
    event_groups: dict[str, int]
    protections: Mapping[str, E2eProtection] = MappingProxyType({})
    """Protections of events that are protected end to end, by name."""


def services(context: Context) -> tuple[Service, ...]:
    """Every service, by name."""
    report_rivals(context)
    reported = (side for side in context.exchange.sides if context.exchange.element(side).is_reported)
    by_key = grouped(((group_of(side, context), side) for side in reported), lambda pair: pair[0].key)
    names = distinct({key: pairs[0][0].name for key, pairs in by_key.items()})
    for key, ((group, side), *_) in by_key.items():
        _report_renamed(names[key], Subject(group.name, side.interface), context)
    listed = Names(sorted(names.values()), identifiers.SERVICES)
    service_ids = numbers(listed, context)
    given = dict.fromkeys(listed.listed, identifiers.INSTANCES)
    ruled = listed._replace(span=identifiers.RULED_INSTANCES, suffix=identifiers.INSTANCE, given=given)
    instances = numbers(ruled, context)
    return tuple(
        _service(by_key[key], name, service_ids[name], instances[name], context)
        for key, name in sorted(names.items(), key=lambda pair: pair[1])
    )


def element_paths(all_services: Iterable[Service]) -> dict[int, str]:
    """`Service/Event` of each interface, by the identity of the interface."""
    return {
        id(side.interface): f"{service.name}/{element.name}"
        for service in all_services
        for element in service.elements
        for side in element.sides
    }


def _service(listed: Sequence[tuple[Group, Side]], name: str, number: int, instance: int, context: Context) -> Service:
    elements, scope = _elements([side for _, side in listed], name, context), f"{name}."
    events = {element.name for element in elements if element.is_event}
    fields = {element.name for element in elements if element.is_field}
    methods = {element.name for element in elements if element.is_method} | {f"Get{field}" for field in fields}
    ids = {
        **numbers(Names(sorted(events | fields), identifiers.EVENTS, scope), context),
        **numbers(Names(sorted(methods), identifiers.METHODS, scope), context),
    }
    chosen = context.settings.transport.get(name, DEFAULT_TRANSPORT)
    groups = {event_group_of(element, chosen) for element in elements} - {""}
    event_groups = numbers(Names(sorted(groups), identifiers.EVENT_GROUPS, scope), context)
    return Service(listed[0][0], name, number, instance, elements, ids, event_groups)


_IN_DIGESTS: Mapping[Kind, str] = {"data": "Signal", "method": "MethodInterface", "mode out": "ModeInterface"}
"""Words of which digests in names are made: names of services that are in use do not change."""


def _elements(sides: Sequence[Side], service: str, context: Context) -> tuple[Element, ...]:
    """Elements of a service by name."""
    found = grouped(sides, lambda side: f"{side.identity} {_IN_DIGESTS.get(side.kind, 'ErrorInterface')}")
    wanted = {key: _wanted(listed[0]) for key, listed in found.items()}
    names = distinct(wanted)
    made = []
    for key, listed in found.items():
        _report_renamed(f"{service}.{names[key]}", Subject(f"{service}.{wanted[key]}", listed[0].interface), context)
        made.append(Element(listed[0].kind, listed[0].identity, tuple(listed), names[key]))
    return tuple(sorted(made, key=lambda element: element.name))


def _wanted(side: Side) -> str:
    return event_name(side.identity) if side.kind == "data" and side.path else short_name(side.identity)


def _report_renamed(name: str, wanted: Subject, context: Context) -> None:
    if name != wanted.name:
        message = f"{wanted} is the name of another interface too: short names have no dots, and case does not count. This one is {name}."
        context.findings.report(codes.NAME_TAKEN, message, wanted)


def event_group_of(element: Element, chosen: TransportSettings) -> str:
    """Event group of an element: the one that names it, or fields have one, events one for each cycle; methods have none."""
    if element.is_method:
        return ""
    if chosen.event_groups == "one":
        return EVENT_GROUP
    if chosen.event_groups != "cycle":
        named = (group for group, names in chosen.event_groups.items() if element.name in names)
        return next(named, None) or _group_by_cycle(element)
    return _group_by_cycle(element)


def _group_by_cycle(element: Element) -> str:
    if element.is_field:
        return FIELD_GROUP
    cycle = cycle_of(element)
    return EVENT_GROUP if cycle is None else f"Cycle{time_in_a_name(cycle)}"


def cycle_of(element: Element) -> float | None:
    """Cycle of the call that provides it, in ms."""
    provider = element.provider
    return provider.call.cycle_time if provider and provider.call else None
