"""Values of a declaration as they are sent: in the unit of the catalogue, exact."""

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from sigcat.function.document.text import json_of
from sigcat.function.function_json.conversion import of_text
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal

Scaled = Signal | DataQueue | ParameterInterface


def sent(value: float | None, interface: Scaled) -> int | float | None:
    """A value of the code, in the unit in which it is sent; None if it is not known."""
    if value is None or interface.conversion_factor is None:
        return value
    factor, offset = of_text(interface.conversion_factor), of_text(interface.conversion_offset or "0")
    if factor is None or offset is None:
        return None
    exact = Fraction(value) * factor + offset
    try:
        return int(exact) if exact.denominator == 1 else float(exact)
    except OverflowError:
        return None


Enumeration = tuple[Mapping[int, str], Mapping[str, int]]
"""Names of the numbers of an enumeration in the code, and the numbers that are sent for these names."""


def initial(interface: Scaled, enumeration: Enumeration | None = None) -> Any:
    """Start value of an interface, as it is sent; None if the declaration has none."""
    if interface.init_elements is not None:
        return _each(json_of(interface.init_elements), interface)
    value = interface.init_value if interface.init_value is not None else interface.default
    if value is not None and enumeration is not None:
        names, numbers = enumeration
        return numbers.get(names.get(int(value), ""), value)
    return sent(value, interface)


def _each(value: Any, interface: Scaled) -> Any:
    """Every number of a list or an object, as it is sent."""
    if isinstance(value, list):
        return [_each(each, interface) for each in value]
    if isinstance(value, dict):
        return value
    return value if isinstance(value, bool | str) else sent(value, interface)
