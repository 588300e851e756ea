"""Interfaces of the set: one for each element, in the words of the side that provides it."""

from collections.abc import Iterable, Mapping
from fractions import Fraction

from sigcat.function.exchange import Side
from sigcat.function.function_json.datatypes.datatype import innermost
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.interfaces.methods import MethodInterface
from sigcat.function.function_json.interfaces.role import PROVIDER
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, ModeInterface, SafetyReaction
from sigcat.integration.autosar_classic import model
from sigcat.integration.autosar_classic.base_software import failing_interface
from sigcat.integration.autosar_classic.context import Context
from sigcat.integration.autosar_classic.datatypes.classic_types import Meaning
from sigcat.integration.autosar_classic.elements import Element
from sigcat.integration.autosar_names import distinct, short_name
from sigcat.integration.sent_values import sent

PLAIN_QUEUE = 16
"""Values that wait for a call which declares no queue, where another side of the element does."""
CALL_QUEUE = 1
"""Calls that wait at a server."""


def queue_length(element: Element, sides: Iterable[Side]) -> int:
    """Values that wait at a receiver: beside those for which the core has room, what may come before it takes them.
    So the core decides what is lost, and not the RTE, which drops the newest value."""
    room = _longest_queue(sides)
    burst = _longest_queue(side for side in element.sides if side.provides)
    return room + max(room, burst) if room else max(PLAIN_QUEUE, burst)


def _longest_queue(sides: Iterable[Side]) -> int:
    return max((side.interface.queue_length for side in sides if isinstance(side.interface, DataQueue)), default=0)


def data_interface(element: Element, context: Context) -> model.SenderReceiverInterface:
    """The interface of a signal or a status."""
    side = element.leading
    meaning = _meaning(side, context)
    data = model.DataElement(
        name=element.leaf,
        type=context.types.application(element.name, type_of(side, context), meaning),
        description=meaning.description,
        queued=True if element.is_queued else None,
        vss_path=side.path or None,
        unit=meaning.unit or None,
    )
    return model.SenderReceiverInterface(name=element.name, elements=(data,), description=meaning.description)


def type_of(side: Side, context: Context) -> str:
    """Implementation type of a side's sent or received values."""
    interface, function = side.interface, side.part.function
    if isinstance(interface, Signal | DataQueue):
        return context.types.sent(function, interface)
    if isinstance(interface, ErrorInterface) and not side.provides:
        return context.types.primitive("uint8")
    assert isinstance(interface, ErrorInterface | SafetyReaction | ModeInterface)
    return context.types.of_reference(function, interface.datatype)


def numbers_of_status(side: Side, context: Context) -> Mapping[str, int]:
    """Numbers of the states of an error or a reaction, by name."""
    interface = side.interface
    assert isinstance(interface, ErrorInterface | SafetyReaction | ModeInterface)
    datatype = innermost(interface.datatype, context.types.datatypes(side.part.function))
    return {each.symbol: each.value for each in (datatype.symbols or ())} if datatype else {}


def _meaning(side: Side, context: Context) -> Meaning:
    interface = side.interface
    if not isinstance(interface, Signal | DataQueue):
        return Meaning(description=interface.description or None)
    is_catalogue = interface.vss_datatype is not None
    unit = (interface.vss_unit or interface.units) if is_catalogue else interface.units
    low, high = interface.vss_min, interface.vss_max
    if context.types.numbers(side.part.function, interface):
        low = high = None
    elif low is None and high is None and interface.role == PROVIDER:
        low, high = sent(interface.min, interface), sent(interface.max, interface)
    return Meaning(unit or None, low, high, interface.description or None)


def mode_interface(element: Element, context: Context) -> tuple[model.ModeSwitchInterface, model.ModeGroup]:
    """The interface of a mode, and its modes."""
    interface = element.leading.interface
    assert isinstance(interface, ModeInterface)
    numbers = numbers_of_status(element.leading, context)
    names = distinct({name: short_name(name) for name in interface.modes})
    modes = tuple(
        model.ModeNumber(name=names[name], value=numbers.get(name, index)) for index, name in enumerate(interface.modes)
    )
    highest = max((mode.value for mode in modes), default=0)
    group = model.ModeGroup(
        name=f"{element.name}_Modes",
        modes=modes,
        initial=names.get(interface.initial or "", modes[0].name if modes else ""),
        type=context.types.of_reference(element.leading.part.function, interface.datatype),
        on_transition=highest + 1,
    )
    return model.ModeSwitchInterface(name=element.name, group=group.name, prototype=element.leaf), group


def method_interface(element: Element, context: Context) -> model.ClientServerInterface:
    """The interface of a method."""
    side = element.leading
    method = side.interface
    assert isinstance(method, MethodInterface)
    function = side.part.function
    arguments = (
        model.OperationArgument(
            name=short_name(each.name),
            type=context.types.of_reference(function, each.datatype),
            direction="IN" if each in method.inputs else "OUT",
            unit=each.units or None,
        )
        for each in (*method.inputs, *method.outputs)
    )
    description = method.description or None
    operation = model.Operation(name=element.leaf, arguments=tuple(arguments), description=description)
    return failing_interface(element.name, operation)


def in_seconds(milliseconds: float | None) -> float:
    """Seconds of so many ms."""
    exact = Fraction(str(milliseconds or 0)) / 1000
    return exact.numerator if exact.denominator == 1 else float(exact)
