"""View of a component on each service: events, methods and fields, with those that it uses."""

from collections.abc import Iterable, Sequence

from sigcat.function.exchange import Side
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.interfaces.methods import Argument, MethodInterface
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.integration.autosar_adaptive import model
from sigcat.integration.autosar_adaptive.code import MethodUse
from sigcat.integration.autosar_adaptive.context import Context
from sigcat.integration.autosar_adaptive.deployment.transport import DEFAULT_TRANSPORT
from sigcat.integration.autosar_adaptive.services.elements import Element, Service, cycle_of, event_group_of
from sigcat.integration.autosar_names import distinct_names, short_name
from sigcat.integration.sent_values import sent


def view(service: Service, part: str, context: Context) -> tuple[model.Services, bool] | None:
    """Return a component's part of a service, and whether it provides it; None if it does not take part in it."""
    own = ((element, [side for side in element.sides if side.part.name == part]) for element in service.elements)
    mine = [(element, sides) for element, sides in own if sides]
    if not mine:
        return None
    return model.Services(
        events=tuple(_event(service, element, sides, context) for element, sides in mine if element.is_event),
        methods=tuple(_method(service, element, sides, context) for element, sides in mine if element.is_method),
        fields=tuple(_field(service, element, sides, context) for element, sides in mine if element.is_field),
    ), service.group.provider == part


def _event(service: Service, element: Element, sides: list[Side], context: Context) -> model.Event:
    leading = element.leading
    interface = leading.data
    variables = tuple(dict.fromkeys(filter(None, (side.data.variable for side in sides))))
    is_catalogue = interface.vss_datatype is not None
    datatype = context.types.on_the_wire(leading.part.function, interface.datatype, interface.vss_datatype)
    symbols = context.types.symbols_sent(datatype)
    low, high = _limits(interface, symbols, provides=leading.provides)
    return model.Event(
        name=element.name,
        datatype=datatype,
        data_mapping=variables or None,
        description=interface.description,
        event_id=service.ids[element.name],
        event_group=event_group_of(element, context.settings.transport.get(service.name, DEFAULT_TRANSPORT)),
        unit=(interface.vss_unit or interface.units) if is_catalogue else interface.units,
        min=low,
        max=high,
        scaling=None if is_catalogue else _text(interface.factor),
        offset=None if is_catalogue else _text(interface.offset),
        cycle_time=cycle_of(element),
        protection=service.protections.get(element.name),
        vss_path=leading.path or None,
        uses=tuple(_use(side, symbols, context) for side in sides),
    )


_Limits = tuple[int | float | None, int | float | None]


def _limits(interface: Signal | DataQueue, symbols: Sequence[model.Symbol], *, provides: bool) -> _Limits:
    """The range of sent values: the catalogue's, or else the provider's. A consumer's range stays with its use."""
    if symbols:
        numbers = [symbol.value for symbol in symbols]
        return min(numbers), max(numbers)
    if interface.vss_min is not None or interface.vss_max is not None:
        return interface.vss_min, interface.vss_max
    return (sent(interface.min, interface), sent(interface.max, interface)) if provides else (None, None)


def _text(number: str | float | None) -> str | None:
    return None if number is None else str(number)


def _use(side: Side, symbols: Sequence[model.Symbol], context: Context) -> model.Use:
    interface, part = side.data, side.part
    own = context.types.symbols_of_code(part.function, interface.datatype)
    return model.Use(
        function=part.function_name,
        component=part.name,
        call=side.runnable.name,
        code_datatype=context.types.c_definition(part.function, interface.datatype),
        code_symbols=None if set(own) == set(symbols) else own or None,
        signal=interface if isinstance(interface, Signal) else None,
        queue=interface if isinstance(interface, DataQueue) else None,
    )


def _calls(sides: Iterable[Side]) -> tuple[str, ...]:
    return tuple(dict.fromkeys(side.call.name for side in sides if side.call))


def _method(service: Service, element: Element, sides: list[Side], context: Context) -> model.Method:
    leading = element.leading
    assert isinstance(leading.interface, MethodInterface)
    return model.Method(
        name=element.name,
        description=leading.interface.description,
        method_id=service.ids[element.name],
        inputs=_arguments(leading, leading.interface.inputs, context),
        outputs=_arguments(leading, leading.interface.outputs, context),
        calls=_calls(sides),
        uses=tuple(_method_use(side) for side in sides),
    )


def _method_use(side: Side) -> MethodUse:
    assert isinstance(side.interface, MethodInterface)
    return MethodUse(function=side.function, component=side.part.name, call=side.runnable.name, method=side.interface)


def _arguments(side: Side, listed: tuple[Argument, ...], context: Context) -> tuple[model.MethodArgument, ...]:
    names = distinct_names([short_name(argument.name) for argument in listed])
    function = side.part.function
    return tuple(
        model.MethodArgument(
            name=name,
            datatype=context.types.word(function, argument.datatype),
            unit=argument.units or None,
            code_datatype=context.types.c_definition(function, argument.datatype),
            argument=argument,
        )
        for name, argument in zip(names, listed, strict=True)
    )


def _field(service: Service, element: Element, sides: list[Side], context: Context) -> model.ServiceField:
    leading = element.leading
    interface = leading.interface
    assert isinstance(interface, ErrorInterface | SafetyReaction | ModeInterface)
    protection = service.protections.get(element.name)
    return model.ServiceField(
        name=element.name,
        description=interface.description,
        datatype=context.types.word(leading.part.function, interface.datatype),
        notifier_id=service.ids[element.name],
        getter_id=None if protection else service.ids[f"Get{element.name}"],
        event_group=event_group_of(element, context.settings.transport.get(service.name, DEFAULT_TRANSPORT)),
        protection=protection,
        calls=_calls(sides),
        vss_path=interface.vss_path,
        error=interface if isinstance(interface, ErrorInterface) else None,
        safety_reaction=interface if isinstance(interface, SafetyReaction) else None,
        mode=interface if isinstance(interface, ModeInterface) else None,
    )
