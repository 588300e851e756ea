"""Values of signals become the numbers that a network transmits: the signals that are sent, and what their mappings make of values."""

import math
from collections.abc import Iterator
from typing import Any, NamedTuple

from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.datatypes import PRIMITIVES
from sigcat.catalogue.model.definition import SIGNALS
from sigcat.catalogue.model.interfaces import interface_name
from sigcat.catalogue.network.can_database import LARGEST
from sigcat.catalogue.network.mapping import SignalMapping, mappings_of
from sigcat.catalogue.network.mapping_attributes import KUKSA_TARGET, PROFILE
from sigcat.catalogue.network.network_values import NO_FORMULA_VALUE, NOT_HELD, OUTSIDE, UNLISTED, WORD, Unfit, Value
from sigcat.catalogue.network.signal_limits import limited, names

NO_SUCH_NAME = "a text that the database has no number for"


class Outgoing(NamedTuple):
    """A signal that goes to CAN."""

    path: str
    name: str
    """Name of its column."""
    datatype: str
    mapping: SignalMapping


def outgoing_signals(catalogue: Catalogue) -> tuple[Outgoing, ...]:
    """The signals that have `vss2dbc`, else VSS's profile.

    A formula of the profile says how a signal is received, and no formula is turned round: such a signal is not sent.
    """
    return tuple(each for node in catalogue.nodes.values() for each in _outgoing(node))


def _outgoing(node: Node) -> Iterator[Outgoing]:
    datatype = node.values.get("datatype")
    if node.definition.type not in SIGNALS or datatype not in PRIMITIVES:
        return
    mapping = next(mappings_of(node.values, (KUKSA_TARGET, PROFILE)), None)
    if mapping is not None and not (mapping.is_profile and mapping.formula is not None):
        yield Outgoing(node.path, interface_name(node.path), datatype, mapping)


# -- a value ------------------------------------------------------------------------------------------------------


def number_of(signal: Any, value: Value, mapping: SignalMapping) -> float:
    """The number that is transmitted for a value. Raises Unfit."""
    given = _network_value(value, mapping)
    return held(signal, given.number) if isinstance(given, _Raw) else raw_of(signal, given)


def raw_of(signal: Any, given: float | str) -> float:
    """The number that is transmitted for a number in the unit of a signal, or for a name of one. Raises Unfit."""
    conversion = signal.conversion
    if isinstance(given, str):
        numbers = [number for number, name in names(signal).items() if name == given]
        if not numbers:
            raise Unfit(NO_SUCH_NAME)
        return held(signal, numbers[0])
    if not conversion.is_float and not math.isfinite(given):
        raise Unfit(NOT_HELD)
    number = limited(signal, given)
    if number is None:
        raise Unfit(OUTSIDE)
    raw = conversion.numeric_scaled_to_raw(float(number) if conversion.is_float else number)
    return held(signal, float(raw) if conversion.is_float else round(raw))


def held(signal: Any, number: float) -> float:
    """A transmitted number that the bits of a signal hold. Raises Unfit."""
    if signal.conversion.is_float:
        if math.isfinite(number) and abs(number) > LARGEST[signal.length]:
            raise Unfit(NOT_HELD)
        return number
    least = -(2 ** (signal.length - 1)) if signal.is_signed else 0
    if not least <= number < least + 2**signal.length:
        raise Unfit(NOT_HELD)
    return number


class _Raw(NamedTuple):
    """A number as it is transmitted."""

    number: float


def _network_value(value: Value, mapping: SignalMapping) -> float | str | _Raw:
    """A number in the unit of the network's signal, or as it is transmitted, or a name of one. Raises Unfit."""
    if not isinstance(value, str) and value in mapping.markers:
        raise Unfit(WORD)
    if mapping.choices:
        return _of_profile(value, mapping) if mapping.is_profile else _of_list(value, mapping)
    if mapping.formula is not None:
        found = None if isinstance(value, str) else mapping.formula.value(value)
        if found is None:
            raise Unfit(NO_FORMULA_VALUE)
        return int(found) if isinstance(found, bool) else found
    return int(value) if isinstance(value, bool) else value


def _of_list(value: Value, mapping: SignalMapping) -> float | str:
    for choice in mapping.choices:
        if choice.given == value and isinstance(choice.given, str) == isinstance(value, str):
            return int(choice.meant) if isinstance(choice.meant, bool) else choice.meant
    raise Unfit(UNLISTED)


def _of_profile(value: Value, mapping: SignalMapping) -> str | _Raw:
    """A text has the number next to it; a number next to a name of the network has that name."""
    for choice in mapping.choices:
        if isinstance(value, str) and choice.meant == value:
            return _Raw(choice.given)
        if not isinstance(value, str) and choice.given == value:
            return str(choice.meant)
    raise Unfit(UNLISTED)
