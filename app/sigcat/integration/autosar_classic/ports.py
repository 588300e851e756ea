"""Ports of a component, and the interfaces of the set."""

from collections.abc import Iterable, Iterator
from typing import Any

from sigcat.function.exchange import Part, Side
from sigcat.function.function_json.duration import milliseconds, whole
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.interfaces.methods import MethodInterface
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.integration.autosar_classic import model
from sigcat.integration.autosar_classic.context import Context
from sigcat.integration.autosar_classic.e2e import windows_of
from sigcat.integration.autosar_classic.elements import Element
from sigcat.integration.autosar_classic.interfaces import CALL_QUEUE, numbers_of_status, queue_length
from sigcat.integration.sent_values import initial


def data_ports(part: Part, elements: Iterable[Element], context: Context) -> tuple[model.Port, ...]:
    """Ports for everything that the component exchanges with others, by name."""
    made = [port for element in elements for port in _ports(part, element, context)]
    return tuple(sorted(made, key=lambda port: port.name))


def _ports(part: Part, element: Element, context: Context) -> Iterator[model.Port]:
    mine = element.of(part)
    if not mine:
        return
    required = [side for side in mine if not side.provides]
    provided = [side for side in mine if side.provides]
    if required:
        yield _port(element.name, "Required", element, required, context)
    if provided:
        yield _port(f"{element.name}_Out" if required else element.name, "Provided", element, provided, context)
    elif element.kind == "reaction":
        yield _port(f"{element.name}_Out", "Provided", element, required, context)


def _port(name: str, direction: str, element: Element, sides: list[Side], context: Context) -> model.Port:
    return model.Port(
        name=name,
        direction=direction,  # type: ignore[arg-type]
        kind=kind_of_port(element),
        interface=element.name,
        elements=(_element(element, direction, sides, context),),
        description=getattr(sides[0].interface, "description", None) or None,
    )


def kind_of_port(element: Element) -> model.Kind:
    """Kind of the interface of an element."""
    if element.kind == "method":
        return "ClientServer"
    return "ModeSwitch" if element.kind.startswith("mode") else "SenderReceiver"


def _element(element: Element, direction: str, sides: list[Side], context: Context) -> model.Element:
    is_data = kind_of_port(element) == "SenderReceiver"
    is_received = is_data and direction == "Required"
    plain = is_received and not element.is_queued
    is_checked = is_received and any(side.rejection_error for side in sides)
    return model.Element(
        name=element.leaf,
        init=None if element.is_queued or not is_data else initial_of(sides, context),
        queue_length=_queue_length(element, sides, is_received=is_received),
        never_received=True if plain else None,
        update=True if plain else None,
        alive_timeout=0 if plain else None,
        transformer_errors=True if is_checked else None,
        windows=windows_of(element, context.settings.e2e) if is_checked else None,
        uses=tuple(_use(side) for side in sides),
    )


def _queue_length(element: Element, sides: list[Side], *, is_received: bool) -> int | None:
    if element.kind == "method":
        return CALL_QUEUE
    return queue_length(element, sides) if is_received and element.is_queued else None


def _use(side: Side) -> model.Use:
    interface = side.interface
    timeout = getattr(interface, "timeout", None)
    number = milliseconds(timeout) if timeout else None
    return model.Use(
        interface=interface.name,
        kind=_KINDS[type(interface)],
        function=side.part.function_name,
        call=side.call.name if side.call else None,
        timeout=whole(number),
    )


_KINDS: dict[type, Any] = {
    Signal: "signal", DataQueue: "queue", MethodInterface: "method", ErrorInterface: "error",
    SafetyReaction: "safety reaction", ModeInterface: "mode",
}  # fmt: skip


def initial_of(sides: Iterable[Side], context: Context) -> Any:
    """Return an element's value before the first one is sent: the declared one, or 0."""
    for side in sides:
        interface = side.interface
        if isinstance(interface, Signal | DataQueue):
            known = context.types.numbers(side.part.function, interface)
            value = initial(interface, known)
            if value is None and known:
                return min(known[1].values(), default=0)
            if value is not None:
                return value
        if isinstance(interface, SafetyReaction):
            numbers = numbers_of_status(side, context)
            return numbers.get((interface.initial or "INACTIVE").upper(), min(numbers.values(), default=0))
        if isinstance(interface, ErrorInterface):
            numbers = numbers_of_status(side, context)
            return numbers.get("PASSED", min(numbers.values(), default=0))
    return 0
