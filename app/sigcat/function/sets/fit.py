"""Both ends of a signal, at two functions: what does not fit between them."""

from collections.abc import Iterator, Mapping
from fractions import Fraction
from typing import NamedTuple

from sigcat import codes
from sigcat.asil import is_above, level_of
from sigcat.findings import RuleCode
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.datatype import Datatype
from sigcat.function.function_json.duration import milliseconds
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.primitive_types import c_type
from sigcat.function.function_json.role import CONSUMER, PROVIDER
from sigcat.function.function_json.runnable import Runnable

Datum = Signal | DataQueue


class End(NamedTuple):
    """A signal at a call of a function."""

    owner: FunctionJson
    pointer: Pointer
    """Where the signal stands in the document of its owner."""
    runnable: Runnable
    signal: Datum

    @property
    def function(self) -> str:
        """Name of the function."""
        return self.owner.info.function_name

    @property
    def call(self) -> str:
        """Name of the call."""
        return self.runnable.name

    @property
    def path(self) -> str:
        """What both ends of a link have in common: the VSS path, or the name where a document has none."""
        return self.signal.vss_path or self.signal.name

    @property
    def is_provider(self) -> bool:
        """Whether the call writes the signal."""
        return self.signal.role == PROVIDER

    @property
    def is_consumer(self) -> bool:
        """Whether the call reads the signal."""
        return self.signal.role == CONSUMER


class Misfit(NamedTuple):
    """Something in which the ends of a signal contradict each other."""

    rule: RuleCode
    key: str
    """Field of the consumer that says otherwise; empty if it is none."""
    message: str
    fix: str


def misfits(provider: End, consumer: End) -> Iterator[Misfit]:
    """Everything in which a consumer expects something else than its provider gives."""
    wanted, given = consumer.signal, provider.signal
    key, range_ = _other_range(wanted, given)
    for rule, at, misfit, fix in (
        (codes.PROVIDED_AS_ANOTHER_DATATYPE, "Datatype", _other_datatype(consumer, provider), "Agree on one."),
        (
            codes.PROVIDED_IN_ANOTHER_UNIT,
            "Units",
            _other_unit(wanted, given),
            "Agree on one, or give the path in the catalogue.",
        ),
        (
            codes.PROVIDED_BEYOND_THE_RANGE,
            key,
            range_,
            "Widen the range, or say what replaces others: rangeErrorAction.",
        ),
        (
            codes.TIMEOUT_SHORTER_THAN_PROVIDER,
            "Timeout",
            _too_short(wanted, provider.runnable),
            "Wait longer than one cycle of the provider.",
        ),
    ):
        if misfit:
            yield Misfit(rule, at, f"{provider.function} provides {consumer.path!r} {misfit}.", fix)
    level, own = level_of(wanted.asil_level), level_of(given.asil_level)
    if is_above(level, own):
        message = f"{provider.function} provides {consumer.path!r} at {own}, and {consumer.function} needs {level}."
        yield Misfit(codes.PROVIDED_AT_LOWER_ASIL, "", message, "")


# -- datatype and unit --------------------------------------------------------------------------------------------

_PRIMITIVE = frozenset(("Bool", "Float32", "Float64", "UInt8", "UInt16", "UInt32", "SInt8", "SInt16", "SInt32"))
"""The usual datatypes, of which one need not ask whether they are enumerations."""


def _other_datatype(consumer: End, provider: End) -> str:
    wanted, given = consumer.signal, provider.signal
    if wanted.vss_datatype and given.vss_datatype:
        if wanted.vss_datatype != given.vss_datatype:
            return f"as {given.vss_datatype}, and {wanted.vss_datatype} is expected"
        own, other = _symbols(consumer), _symbols(provider)
        return "with other numbers for its values" if own and other and own != other else ""
    own_type, other_type = _type(consumer), _type(provider)
    if own_type is None or other_type is None or _meant(own_type) == _meant(other_type):
        return ""
    return f"as {other_type.c_definition}, and {own_type.c_definition} is expected"


def _meant(datatype: Datatype) -> object:
    return c_type(datatype.c_definition) or datatype.c_definition


def _type(end: End) -> Datatype | None:
    return next((each for each in end.owner.datatypes if each.reference == end.signal.datatype), None)


def _symbols(end: End) -> Mapping[str, int]:
    if end.signal.datatype.removeprefix("DT_") in _PRIMITIVE:
        return {}
    datatype = _type(end)
    return {symbol.symbol: symbol.value for symbol in (datatype.symbols if datatype else None) or ()}


def _other_unit(wanted: Datum, given: Datum) -> str:
    both = bool(wanted.vss_path and given.vss_path)
    own, other = (wanted.vss_unit, given.vss_unit) if both else (wanted.units, given.units)
    return "" if (own or "") == (other or "") else f"in {other or 'no unit'}, and {own or 'no unit'} is expected"


# -- range and time -----------------------------------------------------------------------------------------------


def _other_range(wanted: Datum, given: Datum) -> tuple[str, str]:
    """The limit of the consumer, and what it does not hold; its key is the one in its own unit.

    A consumer that says what replaces a value out of range has said what to do.
    """
    if wanted.range_error_action:
        return "", ""
    (low, high), (own_low, own_high) = _range(given), _range(wanted)
    keys = ("Max", "Min") if _falls(wanted) else ("Min", "Max")
    if low is not None and own_low is not None and low < own_low - _slack(own_low):
        return keys[0], f"down to {float(low):g}, and values from {float(own_low):g} on are expected"
    if high is not None and own_high is not None and high > own_high + _slack(own_high):
        return keys[1], f"up to {float(high):g}, and values up to {float(own_high):g} are expected"
    return "", ""


def _slack(bound: Fraction) -> Fraction:
    """Rounding of limits that were converted and written as decimal numbers."""
    return abs(bound) * Fraction(1, 10**9)


def _range(datum: Datum) -> tuple[Fraction | None, Fraction | None]:
    """The range in the unit of the catalogue."""
    try:
        factor, offset = Fraction(datum.conversion_factor or 1), Fraction(datum.conversion_offset or 0)
    except (ValueError, ZeroDivisionError):
        return None, None
    ends = [None if end is None else Fraction(end) * factor + offset for end in (datum.min, datum.max)]
    return (ends[1], ends[0]) if factor < 0 else (ends[0], ends[1])


def _falls(datum: Datum) -> bool:
    """Whether the function's number falls where the catalogue's rises."""
    return (datum.conversion_factor or "").strip().startswith("-")


def _too_short(wanted: Datum, provider: Runnable) -> str:
    timeout, cycle = milliseconds(wanted.timeout), provider.cycle_time
    if timeout is None or not cycle or timeout >= cycle:
        return ""
    return f"every {cycle} ms, and its time-out is {timeout:g} ms"
