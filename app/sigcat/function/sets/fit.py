"""Differences between the ends of a signal, at two functions."""

from collections.abc import Iterator
from fractions import Fraction
from typing import NamedTuple

from sigcat import codes
from sigcat.asil import is_above
from sigcat.findings import RuleCode
from sigcat.function.exchange import Side
from sigcat.function.function_json.conversion import of_text
from sigcat.function.function_json.datatypes.datatype import Datatype
from sigcat.function.function_json.datatypes.primitive_types import c_type
from sigcat.function.function_json.duration import milliseconds
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal


class Mismatch(NamedTuple):
    """Something in which the ends of a signal contradict each other."""

    rule: RuleCode
    key: str
    """Field of the consumer that says otherwise; empty if it is none."""
    message: str
    fix: str


Mismatches = Iterator[Mismatch]


def mismatches(provider: Side, consumer: Side) -> Mismatches:
    """Everything in which a consumer expects something else than its provider gives."""
    yield from _datatype(provider, consumer)
    yield from _unit(provider, consumer)
    yield from _range(provider, consumer)
    yield from _timeout(provider, consumer)
    yield from _asil(provider, consumer)


# -- datatype and unit --------------------------------------------------------------------------------------------

_PRIMITIVE = frozenset(("Bool", "Float32", "Float64", "UInt8", "UInt16", "UInt32", "SInt8", "SInt16", "SInt32"))
"""The usual datatypes, of which one need not ask whether they are enumerations."""


def _datatype(provider: Side, consumer: Side) -> Mismatches:
    given, wanted = _names_of_datatypes(provider, consumer)
    message = ""
    if given != wanted:
        message = (
            f"The datatype of {consumer.identity!r} must be {given}, as {provider.function} provides it, not {wanted}."
        )
    elif _have_other_symbols(provider, consumer):
        message = (
            f"The values of {consumer.identity!r} must be {', '.join(_symbols(provider))}, as {provider.function} provides"
            f" them, not {', '.join(_symbols(consumer))}."
        )
    if message:
        yield Mismatch(codes.PROVIDED_AS_ANOTHER_DATATYPE, "Datatype", message, "Use the same datatype in both.")


def _names_of_datatypes(provider: Side, consumer: Side) -> tuple[str, str]:
    """The datatypes of both ends by VSS, or where one does not say so, by C; equal if they mean the same."""
    given, wanted = provider.data.vss_datatype, consumer.data.vss_datatype
    if given and wanted:
        return given, wanted
    own, other = _type(provider), _type(consumer)
    if own is None or other is None or _meaning(own) == _meaning(other):
        return "", ""
    return own.c_definition, other.c_definition


def _meaning(datatype: Datatype) -> object:
    return c_type(datatype.c_definition) or datatype.c_definition


def _type(end: Side) -> Datatype | None:
    return next((each for each in end.part.function.datatypes if each.reference == end.data.datatype), None)


def _have_other_symbols(provider: Side, consumer: Side) -> bool:
    if not (provider.data.vss_datatype and consumer.data.vss_datatype):
        return False
    given, wanted = _symbols(provider), _symbols(consumer)
    return bool(given and wanted and set(given) != set(wanted))


def _symbols(end: Side) -> tuple[str, ...]:
    """Names of the values of an enumeration. Their numbers may differ: integrations convert them by name."""
    if end.data.datatype.removeprefix("DT_") in _PRIMITIVE:
        return ()
    datatype = _type(end)
    return tuple(symbol.symbol for symbol in (datatype.symbols if datatype else None) or ())


def _unit(provider: Side, consumer: Side) -> Mismatches:
    given, wanted = provider.data, consumer.data
    both = bool(given.vss_path and wanted.vss_path)
    own, other = (given.vss_unit, wanted.vss_unit) if both else (given.units, wanted.units)
    if (own or "") != (other or ""):
        message = (
            f"The unit of {consumer.identity!r} must be {own or 'none'}, as {provider.function} provides it,"
            f" not {other or 'none'}."
        )
        fix = "Use the same unit in both, or give the path in the catalogue."
        yield Mismatch(codes.PROVIDED_IN_ANOTHER_UNIT, "Units", message, fix)


# -- range and time -----------------------------------------------------------------------------------------------


def _range(provider: Side, consumer: Side) -> Mismatches:
    """In the unit of the catalogue; the key is that of the limit in the consumer's own unit.

    A consumer that says what replaces a value out of range has said what to do; of an enumeration each has its own.
    """
    if consumer.data.range_error_action or _symbols(consumer):
        return
    given, wanted = _range_of(provider.data), _range_of(consumer.data)
    keys = ("Max", "Min") if _falls(consumer.data) else ("Min", "Max")
    for key, end, own, other, sign in (
        (keys[0], "down", given[0], wanted[0], -1),
        (keys[1], "up", given[1], wanted[1], 1),
    ):
        if own is not None and other is not None and (own - other) * sign > abs(other) * _ROUNDING:
            message = (
                f"The range of {consumer.identity!r} must go {end} to {float(own):g}, as {provider.function} provides it,"
                f" not only to {float(other):g}."
            )
            fix = "Widen the range, or say what replaces others: rangeErrorAction."
            yield Mismatch(codes.PROVIDED_BEYOND_THE_RANGE, key, message, fix)
            return


_ROUNDING = Fraction(1, 10**9)
"""Rounding of limits that were converted and written as decimal numbers."""


def _range_of(datum: Signal | DataQueue) -> tuple[Fraction | None, Fraction | None]:
    """The range in the unit of the catalogue."""
    factor, offset = of_text(datum.conversion_factor or "1"), of_text(datum.conversion_offset or "0")
    if factor is None or offset is None:
        return None, None
    ends = [None if end is None else Fraction(end) * factor + offset for end in (datum.min, datum.max)]
    return (ends[1], ends[0]) if factor < 0 else (ends[0], ends[1])


def _falls(datum: Signal | DataQueue) -> bool:
    """Whether the function's number falls where the catalogue's rises."""
    return (datum.conversion_factor or "").strip().startswith("-")


def _timeout(provider: Side, consumer: Side) -> Mismatches:
    timeout, cycle = milliseconds(consumer.data.timeout), provider.runnable.cycle_time
    if timeout is not None and cycle and timeout < cycle:
        message = (
            f"The time-out of {consumer.identity!r} must be at least {cycle} ms, the cycle in which {provider.function}"
            f" provides it, not {timeout:g} ms."
        )
        fix = "Wait longer than one cycle of the provider."
        yield Mismatch(codes.TIMEOUT_SHORTER_THAN_PROVIDER, "Timeout", message, fix)


# -- safety -------------------------------------------------------------------------------------------------------


def _asil(provider: Side, consumer: Side) -> Mismatches:
    given, wanted = provider.asil, consumer.asil
    if is_above(wanted, given):
        message = (
            f"{provider.function} must provide {consumer.identity!r} at ASIL {wanted}, as {consumer.function} needs it,"
            f" not at {given}."
        )
        fix = f"Develop the provider to {wanted}, or let the consumer need less."
        yield Mismatch(codes.PROVIDED_AT_LOWER_ASIL, "", message, fix)
