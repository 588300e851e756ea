"""Events, methods and fields of each service: named, typed, with ids, and with every side that takes part."""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from typing import NamedTuple

from sigcat import codes
from sigcat.function.function_json.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.methods import Method
from sigcat.function.function_json.status_interfaces import Error
from sigcat.integration.autosar_adaptive.context import Context, Item
from sigcat.integration.autosar_adaptive.grouping import Group, Placed
from sigcat.integration.autosar_adaptive.identifiers import (
    EVENT_GROUPS,
    EVENTS,
    INSTANCES,
    METHODS,
    SERVICES,
    Span,
    assign,
)
from sigcat.integration.autosar_names import distinct, event_name, short_name
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


def services(placed: Sequence[Placed], context: Context) -> tuple[Service, ...]:
    """Every service, by name."""
    by_origin: defaultdict[str, list[Placed]] = defaultdict(list)
    for side in placed:
        by_origin[_key(side.group)].append(side)
    names = distinct({key: sides[0].group.name for key, sides in by_origin.items()})
    for key, sides in by_origin.items():
        _report_renamed(names[key], Subject(sides[0].group.name, sides[0].item.interface), context)
    numbers = _numbers(names.values(), SERVICES, context, "", "")
    instances = _numbers(names.values(), INSTANCES, context, "", ":instance")
    return tuple(
        _service(by_origin[key], name, numbers[name], instances[name], context)
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
    fields = {element.name for element in elements if element.kind is Error}
    methods = {element.name for element in elements if element.kind is Method}
    ids = {
        **_numbers(events | fields, EVENTS, context, f"{name}.", ""),
        **_numbers(methods | {f"Get{field}" for field in fields}, METHODS, context, f"{name}.", ""),
    }
    groups = {group_of(element) for element in elements} - {""}
    return Service(
        sides[0].group, name, number, instance, elements, ids, _numbers(groups, EVENT_GROUPS, context, f"{name}.", "")
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
    return Method if isinstance(item.interface, Method) else Error


def _wanted(identity: str, side: Placed, context: Context) -> str:
    is_data = isinstance(side.item.interface, Signal | DataQueue)
    return event_name(identity) if is_data and context.path_of(side.item) else short_name(identity)


def _report_renamed(name: str, wanted: Subject, context: Context) -> None:
    if name != wanted.name:
        message = f"{wanted} is the name of another interface too: short names have no dots, and case does not count. This one is {name}."
        context.findings.report(codes.NAME_TAKEN, message, wanted)


def _numbers(names: Iterable[str], span: Span, context: Context, scope: str, suffix: str) -> dict[str, int]:
    """Ids, those of the deployment first; what is wrong with them is reported."""
    listed = sorted(set(names))
    given = context.settings.identifiers
    fixed: dict[str, int] = {}
    for name in listed:
        number = given.get(f"{scope}{name}{suffix}")
        if number is None:
            continue
        if not span.first <= number <= span.last or number in fixed.values():
            reason = (
                "must not be used twice"
                if number in fixed.values()
                else f"must be from 0x{span.first:04X} to 0x{span.last:04X}"
            )
            message = f"Id 0x{number:04X} of {scope}{name}{suffix} in the deployment file {reason}."
            context.findings.report(codes.ID_REFUSED, message, f"{scope}{name}", "Use another one.")
            continue
        fixed[name] = number
    if len(listed) > span.last - span.first + 1:
        message = (
            f"At most {span.last - span.first + 1} names can have an id of this kind in SOME/IP, not {len(listed)}."
        )
        context.findings.report(codes.ID_REFUSED, message, scope.rstrip("."), "Spread them over several services.")
        return dict.fromkeys(listed, span.first)
    assigned = assign(listed, span, fixed, f"{scope}{suffix}")
    for name, other, number in assigned.collisions:
        message = f"{scope}{name} and {scope}{other} have the same digest: id 0x{number:04X} changes if one of them is removed."
        fix = f"To keep it, fix it in the deployment file: identifiers: {{{scope}{name}{suffix}: {number}}}."
        context.findings.report(codes.ID_DEPENDS_ON_OTHERS, message, f"{scope}{name}", fix)
    return assigned.ids


def group_of(element: Element) -> str:
    """Event group of an element: fields have one, events one for each cycle; methods have none."""
    if element.kind is Method:
        return ""
    if element.kind is Error:
        return FIELD_GROUP
    cycle = cycle_of(element)
    return EVENT_GROUP if cycle is None else f"Cycle{cycle}ms"


def cycle_of(element: Element) -> int | None:
    """Cycle of the call that provides it, in ms."""
    side = element.leading
    return side.item.call.cycle_time if side.provides and side.item.call else None
