"""Events, methods and fields of each service: named, typed, with ids, and with every side that takes part."""

import re
from collections import defaultdict
from collections.abc import Iterable, Sequence
from fractions import Fraction
from typing import NamedTuple

from sigcat import codes
from sigcat.function.function_json.model import (
    Argument,
    DataQueue,
    Error,
    Method,
    ModeInterface,
    SafetyReaction,
    Signal,
)
from sigcat.integration.autosar_adaptive import model
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
from sigcat.integration.autosar_adaptive.types import TypeTable
from sigcat.integration.autosar_names import distinct, event_name, short_name

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
    _report_renamed({names[key]: sides[0].group.name for key, sides in by_origin.items()}, context)
    numbers = _numbers(names.values(), SERVICES, context, "", "")
    instances = _numbers(names.values(), INSTANCES, context, "", ":instance")
    return tuple(
        _service(by_origin[key], name, numbers[name], instances[name], context)
        for key, name in sorted(names.items(), key=lambda pair: pair[1])
    )


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
    _report_renamed({f"{service}.{names[key]}": f"{service}.{wanted[key]}" for key in wanted}, context)
    made = [
        Element(names[f"{identity} {kind.__name__}"], identity, kind, tuple(listed))
        for (identity, kind), listed in found.items()
    ]
    return tuple(sorted(made, key=lambda element: element.name))


def _kind(item: Item) -> type:
    if isinstance(item.interface, Signal | DataQueue):
        return Signal
    return Method if isinstance(item.interface, Method) else Error


def _wanted(identity: str, side: Placed, context: Context) -> str:
    is_data = isinstance(side.item.interface, Signal | DataQueue)
    return event_name(identity) if is_data and context.path_of(side.item) else short_name(identity)


def _report_renamed(wanted: dict[str, str], context: Context) -> None:
    for name, plain in wanted.items():
        if name != plain:
            message = f"{plain} is the name of another interface too: short names have no dots, and case does not count. This one is {name}."
            context.findings.report(codes.NAME_TAKEN, message, plain)


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


# -- what a component has of a service ----------------------------------------------------------------------------


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


def view(service: Service, part: str, types: TypeTable, context: Context) -> tuple[model.Services, bool] | None:
    """What a component has of a service, and whether it provides it; None if it has nothing to do with it."""
    provider = service.group.provider
    provides = provider is not None and provider.name == part
    mine = [
        (element, [side for side in element.sides if side.item.part.name == part])
        for element in service.elements
        if any(side.item.part.name == part for side in element.sides)
    ]
    if not mine:
        return None
    return model.Services(
        events=tuple(
            _event(service, element, sides, types, context) for element, sides in mine if element.kind is Signal
        ),
        methods=tuple(_method(service, element, sides, types) for element, sides in mine if element.kind is Method),
        fields=tuple(_field(service, element, sides, types) for element, sides in mine if element.kind is Error),
    ), provides


def _event(service: Service, element: Element, sides: list[Placed], types: TypeTable, context: Context) -> model.Event:
    leading = element.leading.item
    interface = leading.interface
    assert isinstance(interface, Signal | DataQueue)
    variables = tuple(dict.fromkeys(filter(None, map(_variable, sides))))
    is_catalogue = _in_catalogue_datatype(interface)
    return model.Event(
        name=element.name,
        datatype=types.on_the_wire(leading.part.function, interface.datatype, interface.vss_datatype),
        data_mapping=variables or None,
        description=interface.description,
        event_id=service.ids[element.name],
        event_group=group_of(element),
        unit=(interface.vss_unit or interface.units) if is_catalogue else interface.units,
        min=sent(interface.min, interface),
        max=sent(interface.max, interface),
        scaling=None if is_catalogue else _text(interface.factor),
        offset=None if is_catalogue else _text(interface.offset),
        cycle_time=cycle_of(element),
        vss_path=context.path_of(leading) or None,
        uses=tuple(_use(side, types) for side in sides),
    )


def _variable(side: Placed) -> str | None:
    interface = side.item.interface
    return interface.variable if isinstance(interface, Signal | DataQueue) else None


def _in_catalogue_datatype(interface: Signal | DataQueue) -> bool:
    return interface.vss_datatype is not None


def sent(value: float | None, interface: Signal | DataQueue) -> int | float | None:
    """A limit of the code, in the unit in which the value is sent, exact; None if it is not known."""
    if value is None or interface.conversion_factor is None:
        return value
    factor, offset = _fraction(interface.conversion_factor), _fraction(interface.conversion_offset or "0")
    if factor is None or offset is None:
        return None
    exact = Fraction(value) * factor + offset
    try:
        return int(exact) if exact.denominator == 1 else float(exact)
    except OverflowError:
        return None


_DECIMAL = re.compile(r"[+-]?\d{1,40}(?:\.\d{1,40})?(?:[eE][+-]?\d{1,3}|/0*[1-9]\d{0,39})?")
"""A number, of a size that exact arithmetic bears."""


def _fraction(text: str) -> Fraction | None:
    return Fraction(text) if _DECIMAL.fullmatch(text) else None


def _text(number: str | float | None) -> str | None:
    return None if number is None else str(number)


def _use(side: Placed, types: TypeTable) -> model.Use:
    interface, call, part = side.item.interface, side.item.call, side.item.part
    assert isinstance(interface, Signal | DataQueue)
    assert call is not None
    return model.Use(
        function=part.function_name,
        component=part.name,
        call=call.name,
        code_datatype=types.c_definition(part.function, interface.datatype),
        signal=interface if isinstance(interface, Signal) else None,
        queue=interface if isinstance(interface, DataQueue) else None,
    )


def _calls(sides: Iterable[Placed]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(side.item.call.name for side in sides if side.item.call))


def _method(service: Service, element: Element, sides: list[Placed], types: TypeTable) -> model.Method:
    leading = element.leading.item
    assert isinstance(leading.interface, Method)
    return model.Method(
        name=element.name,
        description=leading.interface.description,
        method_id=service.ids[element.name],
        inputs=_arguments(leading, leading.interface.inputs, types),
        outputs=_arguments(leading, leading.interface.outputs, types),
        calls=_calls(sides),
    )


def _arguments(item: Item, listed: tuple[Argument, ...], types: TypeTable) -> tuple[model.MethodArgument, ...]:
    names = distinct({f"{index:06d}": short_name(argument.name) for index, argument in enumerate(listed)})
    function = item.part.function
    return tuple(
        model.MethodArgument(
            name=names[f"{index:06d}"],
            datatype=types.word(function, argument.datatype),
            unit=argument.units or None,
            code_datatype=types.c_definition(function, argument.datatype),
            argument=argument,
        )
        for index, argument in enumerate(listed)
    )


def _field(service: Service, element: Element, sides: list[Placed], types: TypeTable) -> model.ServiceField:
    leading = element.leading.item
    interface = leading.interface
    assert isinstance(interface, Error | SafetyReaction | ModeInterface)
    return model.ServiceField(
        name=element.name,
        description=interface.description,
        datatype=types.word(leading.part.function, interface.datatype),
        notifier_id=service.ids[element.name],
        getter_id=service.ids[f"Get{element.name}"],
        event_group=FIELD_GROUP,
        calls=_calls(sides),
        vss_path=interface.vss_path,
        error=interface if isinstance(interface, Error) else None,
        safety_reaction=interface if isinstance(interface, SafetyReaction) else None,
        mode=interface if isinstance(interface, ModeInterface) else None,
    )


def report_disagreements(all_services: Iterable[Service], types: TypeTable, context: Context) -> None:
    """Report where the sides of an event differ in what they take to be sent."""
    for service in all_services:
        for element in service.elements:
            if element.kind is Signal:
                _compare(element, types, context)


def _compare(element: Element, types: TypeTable, context: Context) -> None:
    leading = element.leading
    wanted = _sent_as(leading, types)
    for side in element.sides:
        found = _sent_as(side, types)
        if found != wanted:
            message = (
                f"{element.identity}: {side.item.where} takes it as {found[0]} in {found[1] or 'no unit'}, "
                f"{leading.item.where} as {wanted[0]} in {wanted[1] or 'no unit'}, which is what is sent."
            )
            context.findings.report(
                codes.MEANINGS_DIFFER_ADAPTIVE, message, element.identity, "Build both from the same catalogue."
            )


def _sent_as(side: Placed, types: TypeTable) -> tuple[str, str]:
    interface = side.item.interface
    assert isinstance(interface, Signal | DataQueue)
    word = types.on_the_wire(side.item.part.function, interface.datatype, interface.vss_datatype)
    return word, (interface.vss_unit or interface.units or "")
