"""Events, methods and fields of each service: named, typed, with ids, and with every side that takes part."""

from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from sigcat import codes
from sigcat.function.function_json.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.duration import time_in_a_name
from sigcat.function.function_json.methods import MethodInterface
from sigcat.function.function_json.status_interfaces import ErrorInterface
from sigcat.integration.autosar_adaptive.context import Context
from sigcat.integration.autosar_adaptive.e2e import E2eProtection
from sigcat.integration.autosar_adaptive.grouping import Group, Placed
from sigcat.integration.autosar_adaptive.identifiers import (
    EVENT_GROUPS,
    EVENTS,
    INSTANCE,
    INSTANCES,
    METHODS,
    RULED_INSTANCES,
    SERVICES,
)
from sigcat.integration.autosar_adaptive.numbering import Names, numbers
from sigcat.integration.autosar_adaptive.transport import DEFAULT_TRANSPORT, TransportSettings
from sigcat.integration.autosar_names import distinct, event_name, short_name
from sigcat.integration.autosar_parts import Item
from sigcat.integration.finding_collector import Subject

FIELD_GROUP = "Fields"
"""Event group of the notifiers of fields."""
EVENT_GROUP = "Events"
"""Event group of the events whose cycle is not known."""


class Element(NamedTuple):
    """An event, a method or a field, and its sides."""

    name: str
    identity: str
    kind: type
    sides: tuple[Placed, ...]

    @property
    def leading(self) -> Placed:
        """The side that says what is sent: the provider, or the first consumer."""
        return next((side for side in self.sides if side.provides), self.sides[0])


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


def services(placed: Sequence[Placed], context: Context) -> tuple[Service, ...]:
    """Every service, by name."""
    by_origin: defaultdict[str, list[Placed]] = defaultdict(list)
    for side in placed:
        by_origin[_key(side.group)].append(side)
    names = distinct({key: sides[0].group.name for key, sides in by_origin.items()})
    for key, sides in by_origin.items():
        _report_renamed(names[key], Subject(sides[0].group.name, sides[0].item.interface), context)
    service_ids = numbers(Names(sorted(names.values()), SERVICES), context)
    given = dict.fromkeys(names.values(), INSTANCES)
    instances = numbers(Names(sorted(names.values()), RULED_INSTANCES, suffix=INSTANCE, given=given), context)
    return tuple(
        _service(by_origin[key], name, service_ids[name], instances[name], context)
        for key, name in sorted(names.items(), key=lambda pair: pair[1])
    )


def element_paths(all_services: Iterable[Service]) -> dict[int, str]:
    """`Service/Event` of each interface, by the identity of the interface."""
    return {
        id(side.item.interface): f"{service.name}/{element.name}"
        for service in all_services
        for element in service.elements
        for side in element.sides
    }


def _key(group: Group) -> str:
    return f"{'component' if group.provider else 'outside'} {group.origin}"


def _service(sides: Sequence[Placed], name: str, number: int, instance: int, context: Context) -> Service:
    elements = _elements(sides, name, context)
    events = {element.name for element in elements if element.kind is Signal}
    fields = {element.name for element in elements if element.kind is ErrorInterface}
    methods = {element.name for element in elements if element.kind is MethodInterface}
    ids = {
        **numbers(Names(sorted(events | fields), EVENTS, f"{name}."), context),
        **numbers(Names(sorted(methods | {f"Get{field}" for field in fields}), METHODS, f"{name}."), context),
    }
    chosen = context.settings.transport.get(name, DEFAULT_TRANSPORT)
    groups = {group_of(element, chosen) for element in elements} - {""}
    return Service(
        sides[0].group,
        name,
        number,
        instance,
        elements,
        ids,
        numbers(Names(sorted(groups), EVENT_GROUPS, f"{name}."), context),
    )


def _elements(sides: Sequence[Placed], service: str, context: Context) -> tuple[Element, ...]:
    """Elements of a service by name. Data interfaces are events, whether queued or not; statuses are fields."""
    found: defaultdict[tuple[str, type], list[Placed]] = defaultdict(list)
    for side in sides:
        found[side.identity, _kind(side.item)].append(side)
    wanted = {
        f"{identity} {kind.__name__}": _wanted(identity, listed[0], context)
        for (identity, kind), listed in found.items()
    }
    names = distinct(wanted)
    made = []
    for (identity, kind), listed in found.items():
        key = f"{identity} {kind.__name__}"
        plain = Subject(f"{service}.{wanted[key]}", listed[0].item.interface)
        _report_renamed(f"{service}.{names[key]}", plain, context)
        made.append(Element(names[key], identity, kind, tuple(listed)))
    return tuple(sorted(made, key=lambda element: element.name))


def _kind(item: Item) -> type:
    if isinstance(item.interface, Signal | DataQueue):
        return Signal
    return MethodInterface if isinstance(item.interface, MethodInterface) else ErrorInterface


def _wanted(identity: str, side: Placed, context: Context) -> str:
    is_data = isinstance(side.item.interface, Signal | DataQueue)
    return event_name(identity) if is_data and context.path_of(side.item) else short_name(identity)


def _report_renamed(name: str, wanted: Subject, context: Context) -> None:
    if name != wanted.name:
        message = f"{wanted} is the name of another interface too: short names have no dots, and case does not count. This one is {name}."
        context.findings.report(codes.NAME_TAKEN, message, wanted)


def group_of(element: Element, chosen: TransportSettings) -> str:
    """Event group of an element: the one that names it, or fields have one, events one for each cycle; methods have none."""
    if element.kind is MethodInterface:
        return ""
    if chosen.event_groups == "one":
        return EVENT_GROUP
    if chosen.event_groups != "cycle":
        named = (group for group, names in chosen.event_groups.items() if element.name in names)
        return next(named, None) or _group_by_cycle(element)
    return _group_by_cycle(element)


def _group_by_cycle(element: Element) -> str:
    if element.kind is ErrorInterface:
        return FIELD_GROUP
    cycle = cycle_of(element)
    return EVENT_GROUP if cycle is None else f"Cycle{time_in_a_name(cycle)}"


def cycle_of(element: Element) -> float | None:
    """Cycle of the call that provides it, in ms."""
    side = element.leading
    return side.item.call.cycle_time if side.provides and side.item.call else None
