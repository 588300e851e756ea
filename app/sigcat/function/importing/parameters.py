"""The parameters that the function defines: datatype, default, unit and range are those of the code."""

import struct
from collections.abc import Iterable, Iterator
from fractions import Fraction
from itertools import chain, count
from typing import Any, NamedTuple

from sigcat.catalogue.model.datatypes import INTEGER_RANGES
from sigcat.catalogue.model.vocabulary import Vocabulary
from sigcat.function.c_project.values import Value
from sigcat.function.importing.unique_names import unique_names
from sigcat.function.importing.units import unit_of
from sigcat.names import camel_case


class ParameterEntry(NamedTuple):
    """A parameter, as it is defined and as the call reads it."""

    value: Value
    name: str
    """CamelCase, unique in the function."""
    definition: dict[str, Any]
    keys: dict[str, Any]


def parameters_of(values: Iterable[Value], vocabulary: Vocabulary) -> Iterator[ParameterEntry]:
    """An entry for each parameter that can be set."""
    settable = [value for value in values if not value.is_const]
    taken, said = set[str](), set[str]()
    for value, own in zip(settable, unique_names(settable), strict=True):
        name = _free(f"Is{_camel(own)}" if value.datatype == "boolean" else _camel(own), taken)
        description = _description(value, own, said)
        definition = _definition(value, unit_of(value.remark.units, vocabulary), description)
        yield ParameterEntry(value, name, definition, _keys(value, name, own))


def _free(name: str, taken: set[str]) -> str:
    """A name that no other one has; names that differ in case alone are one in C of some platforms."""
    free = next(
        each for each in chain((name,), (f"{name}{number}" for number in count(2))) if each.lower() not in taken
    )
    taken.add(free.lower())
    return free


def _description(value: Value, own: str, said: set[str]) -> str:
    """What the comment says, as a sentence, with the name where another one says the same."""
    text = value.remark.text
    sentence = _sentence(text) if text else f"Parameter {own} of the code."
    sentence = f"{sentence[:-1]} ({own})." if sentence in said else sentence
    said.add(sentence)
    return sentence


def _camel(name: str) -> str:
    text = camel_case(name)
    return text if text[:1].isalpha() else f"P{text}"


def _definition(value: Value, unit: str, description: str) -> dict[str, Any]:
    """What the catalogue would say, in physical values."""
    is_scaled = _factor(value) is not None
    datatype = "double" if is_scaled else value.datatype
    smallest, largest = _stored_range(value) if is_scaled else (None, None)
    definition = {
        "datatype": f"{datatype}{'[]' if value.length else ''}",
        "arraysize": value.length or None,
        "unit": unit,
        "min": smallest if value.remark.min is None else value.remark.min,
        "max": largest if value.remark.max is None else value.remark.max,
        "default": _default(value),
        "asil": "QM",
        "description": description,
    }
    return {key: each for key, each in definition.items() if each not in (None, "")}


def _keys(value: Value, name: str, own: str) -> dict[str, Any]:
    factor = _factor(value)
    keys = {
        "path": name,
        "name": own if own != name else None,
        "variable": value.expression,
        "definedBy": "adapter" if value.defined_by == "adapter" else None,
        "datatype": f"{value.datatype}{'[]' if value.length else ''}" if factor is not None else None,
        "factor": factor,
        "offset": value.remark.offset if factor is not None else None,
    }
    return {key: each for key, each in keys.items() if each is not None}


def _factor(value: Value) -> float | int | None:
    is_integer = value.datatype not in ("float", "double", "boolean")
    return value.remark.factor if is_integer and value.remark.factor not in (0, 1) else None


def _stored_range(value: Value) -> tuple[float, float]:
    """The range of physical values that the datatype of the code holds."""
    ends = [_scaled(end, value) for end in INTEGER_RANGES[value.datatype]]
    return min(ends), max(ends)


def _scaled(stored: int, value: Value) -> float:
    factor, offset = Fraction(repr(value.remark.factor)), Fraction(repr(value.remark.offset or 0))
    return float(factor * stored + offset)


def _default(value: Value) -> Any:
    """The value at start-up; 0 where the code has none, or has one that depends on others."""
    if not value.length:
        return _physical(value.start, value)
    start = value.start if isinstance(value.start, list) else []
    return [_physical(each, value) for each in _filled(start, value.length)]


def _filled(start: list[Any], count: int) -> list[Any]:
    """C sets to 0 what an initializer leaves out."""
    return [*start[:count], *([0] * (count - len(start)))]


def _physical(start: Any, value: Value) -> Any:
    stored = start if isinstance(start, int | float) else 0
    if value.datatype == "boolean":
        return bool(stored)
    if value.datatype in ("float", "double"):
        return _shortest(float(stored)) if value.datatype == "float" else float(stored)
    return int(stored) if _factor(value) is None else _scaled(int(stored), value)


def _shortest(value: float) -> float:
    """The shortest number that a C float holds as the same value: 0.1 of 0.10000000149."""
    for digits in range(6, 10):
        candidate = float(f"{value:.{digits}g}")
        if _stored(candidate) == _stored(value):
            return candidate
    return value


def _stored(value: float) -> bytes:
    try:
        return struct.pack("f", value)
    except OverflowError:
        return b""


def _sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:]}".rstrip(".") + "."
