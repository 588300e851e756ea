"""The parameters that the function defines: datatype, default, unit and range are those of the code."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import chain, count
from typing import Any, NamedTuple

from sigcat.catalogue.model.catalogue import Node
from sigcat.catalogue.model.datatypes import INTEGER_RANGES
from sigcat.catalogue.model.vocabulary import Vocabulary
from sigcat.function.c_project.code_values import Value
from sigcat.function.importing.start_values import factor_of, start_of, stored_ends, stored_range
from sigcat.function.importing.unique_names import unique_names
from sigcat.function.importing.units import unit_of, without_unit
from sigcat.function.importing.yaml_text import scalar
from sigcat.names import camel_case


class ParameterEntry(NamedTuple):
    """A parameter, as it is defined and as the call reads it."""

    value: Value
    name: str
    """CamelCase, unique in the function."""
    definition: dict[str, Any]
    """Empty if the catalogue has the parameter already."""
    keys: dict[str, Any]
    notes: tuple[str, ...] = ()
    """Notes for the author about the definition."""


def parameters_of(
    values: Iterable[Value], vocabulary: Vocabulary, known: Mapping[str, Node], names: Iterable[str] = ()
) -> Iterator[ParameterEntry]:
    """An entry for each parameter that can be set. `known` are those of the function in the catalogue, by last name.

    `names` are those that others have already.
    """
    settable = [value for value in values if not value.is_const]
    taken, said = {name.lower() for name in names}, set[str]()
    for value, own in zip(settable, unique_names(settable), strict=True):
        prefix = "Is" if value.datatype == "boolean" else ""
        name = free_name(f"{prefix}{starting_with_letter(own)}", taken)
        if name in known:
            keys = _keys(value, known[name].path, own)
            yield ParameterEntry(value, name, {}, {**keys, **_stored_otherwise(value, known[name])})
            continue
        description = described(value, own, said, vocabulary, "Parameter")
        definition = physical_definition(value, unit_of(value.remark.units, vocabulary), description)
        yield ParameterEntry(value, name, definition, _keys(value, name, own), tuple(_notes(value, definition)))


def _stored_otherwise(value: Value, node: Node) -> dict[str, Any]:
    """The datatype of the code, where the catalogue has another one."""
    datatype = f"{value.datatype}{'[]' if value.length else ''}"
    return {"datatype": datatype} if datatype != node.values["datatype"] else {}


def free_name(name: str, taken: set[str]) -> str:
    """A name that no other one has; names that differ in case alone are one in C of some platforms."""
    numbered = (f"{name}{number}" for number in count(2))
    free = next(each for each in chain((name,), numbered) if each.lower() not in taken)
    taken.add(free.lower())
    return free


def described(value: Value, own: str, said: set[str], vocabulary: Vocabulary, kind: str) -> str:
    """Return the comment as a sentence, with the name where another one says the same."""
    text = without_unit(value.remark.text, value.remark.units, vocabulary)
    sentence = f"{text[:1].upper()}{text[1:]}".rstrip(".") + "." if text else f"{kind} {own} of the code."
    sentence = f"{sentence[:-1]} ({own})." if sentence in said else sentence
    said.add(sentence)
    return sentence


def starting_with_letter(name: str) -> str:
    """A name in CamelCase."""
    text = camel_case(name)
    return text if text[:1].isalpha() else f"P{text}"


def physical_definition(value: Value, unit: str, description: str) -> dict[str, Any]:
    """Return the definition for the catalogue, in physical values."""
    is_scaled = factor_of(value) is not None
    smallest, largest = _range(value)
    definition = {
        "datatype": f"{'double' if is_scaled else value.datatype}{'[]' if value.length else ''}",
        "arraysize": value.length or None,
        "unit": unit,
        "min": smallest,
        "max": largest,
        "default": _default(value, smallest, largest),
        "asil": "QM",
        "description": description,
    }
    return {key: each for key, each in definition.items() if each not in (None, "")}


_Limit = float | int | None


def _range(value: Value) -> tuple[_Limit, _Limit]:
    """The range that the comment tells, if the value is in it; of a scaled value and of a bit field at least what the code can hold."""
    widest: tuple[_Limit, _Limit] = (None, None)
    if factor_of(value) is not None:
        widest = stored_range(value)
    elif value.bits:
        widest = stored_ends(value)
    told = (value.remark.min, value.remark.max)
    if not _holds(value, *told):
        return widest
    return (widest[0] if told[0] is None else told[0]), (widest[1] if told[1] is None else told[1])


def _default(value: Value, smallest: _Limit, largest: _Limit) -> Any:
    """The value at start-up; where the code tells none, 0 or what of the range is nearest to it."""
    start = start_of(value)
    if value.start is not None or isinstance(start, bool):
        return start
    nearest = max(smallest or 0, 0) or min(largest or 0, 0)
    assumed = type(start[0] if isinstance(start, list) else start)(nearest)
    return [assumed] * value.length if value.length else assumed


def _holds(value: Value, smallest: _Limit, largest: _Limit) -> bool:
    """Whether the value at start-up, if the code tells it, and a number of the datatype may be in a range."""
    start = start_of(value) if value.start is not None else []
    starts = start if isinstance(start, list) else [start]
    ends = [end for end in (smallest, largest) if end is not None]
    if value.datatype in INTEGER_RANGES and factor_of(value) is None:
        low, high = stored_ends(value)
        if not all(low <= end <= high and end == int(end) for end in ends):
            return False
    is_above = smallest is None or all(each >= smallest for each in starts)
    return value.datatype != "boolean" and is_above and (largest is None or all(each <= largest for each in starts))


def _notes(value: Value, definition: Mapping[str, Any]) -> Iterator[str]:
    if value.start is None:
        default = definition["default"]
        yield f"The code tells no value: {scalar(default[0] if value.length else default)} is assumed."
    told = (value.remark.min, value.remark.max)
    if any(end is not None for end in told) and (definition.get("min"), definition.get("max")) != told:
        smallest, largest = ("any" if end is None else f"{end:g}" for end in told)
        yield f"Left out: the range of the comment, {smallest} to {largest}, which does not fit the value or the datatype."
    if value.remark.unit and not definition.get("unit"):
        yield f"TODO: the code says {value.remark.unit}, which is not a unit of the catalogue."
    if value.constants:
        yield f"Numbers: {', '.join(f'{each.name} = {each.value}' for each in value.constants)}"


def _keys(value: Value, name: str, own: str) -> dict[str, Any]:
    factor = factor_of(value)
    keys = {
        "path": name,
        "name": own if own != name else None,
        "variable": value.expression,
        "definedBy": "adapter" if value.defined_by == "adapter" else None,
        "cType": value.c_type or None,
        "datatype": f"{value.datatype}{'[]' if value.length else ''}" if factor is not None else None,
        "factor": factor,
        "offset": value.remark.offset if factor is not None else None,
    }
    return {key: each for key, each in keys.items() if each is not None}
