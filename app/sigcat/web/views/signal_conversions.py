"""Conversions of the value of a signal between two functions, or between one and the outside."""

from fractions import Fraction

from sigcat.function.exchange import Side
from sigcat.function.function_json.conversion import IDENTITY, Linear, between, of_text
from sigcat.function.sets.wiring import Link
from sigcat.web.template_filters import number, unit


def within(link: Link) -> str:
    """From the unit of the provider to that of the consumer; empty if the value stays what it is."""
    given, wanted = _to_catalogue(link.provider), _to_catalogue(link.consumer)
    if given is None or wanted is None:
        return ""
    return _text(link.provider.data.units, link.consumer.data.units, given.then(wanted.inverse))


def from_outside(end: Side) -> str:
    """From the unit of the catalogue to that of the function."""
    linear = _to_catalogue(end)
    return _text(end.data.vss_unit, end.data.units, linear.inverse) if linear else ""


def to_outside(end: Side) -> str:
    """From the unit of the function to that of the catalogue."""
    linear = _to_catalogue(end)
    return _text(end.data.units, end.data.vss_unit, linear) if linear else ""


def from_unit_to_unit(source: str, target: str) -> str:
    """From values in one unit to values in another; empty if the value stays what it is, or no conversion is known."""
    linear = between(source, target)
    return _text(source, target, linear) if linear else ""


def stored(end: Side) -> str:
    """`value = EgoSpd × 0.01`: the scaling of the variable; empty if it holds the value itself."""
    factor, offset = of_text(str(end.data.factor or 1)), of_text(str(end.data.offset or 0))
    linear = Linear(factor or Fraction(1), offset or Fraction(0))
    return "" if linear == IDENTITY else f"value = {end.data.name} {_formula(linear)}"


def _to_catalogue(end: Side) -> Linear | None:
    """None where a document has no number in its place."""
    factor, offset = of_text(end.data.conversion_factor or "1"), of_text(end.data.conversion_offset or "0")
    return Linear(factor, offset) if factor and offset is not None else None


def _text(source: str | None, target: str | None, linear: Linear) -> str:
    """`km/h → m/s: × 0.277778`."""
    if linear == IDENTITY:
        return ""
    return f"{unit(source or '1')} → {unit(target or '1')}: {_formula(linear)}"


def _formula(linear: Linear) -> str:
    sign = "+" if linear.offset > 0 else "−"
    offset = f" {sign}\u00a0{_rounded(abs(linear.offset))}" if linear.offset else ""
    return f"×\u00a0{_rounded(linear.factor)}{offset}"


def _rounded(value: Fraction) -> str:
    return number(float(f"{float(value):.6g}"))
