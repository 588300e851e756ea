"""Problems of the attributes of sensors, actuators, attributes and properties: units, ranges, defaults, patterns."""

import re
from collections.abc import Iterator, Mapping
from typing import Any

from sigcat import codes
from sigcat.catalogue.model.datatypes import DATATYPES, belongs_to, element_of, holds, is_array
from sigcat.catalogue.model.definition import Definition, Problem, Scope
from sigcat.names import did_you_mean, screaming_snake_case

_EPSILON = 1e-6
_INTO_RANGE = "Change the default, or the range."
_QUOTE = "Quote it: YAML reads words such as ON, OFF, YES and NO as true and false."


def data_problems(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    """What is wrong with the attributes of a node of a datatype that is there, given by its full name."""
    for attributes, check in _DATA_CHECKS:
        if not attributes.isdisjoint(values):
            yield from check(values, datatype, scope)


def shown(value: Any) -> str:
    """A value as messages show it, cut where it is long."""
    text = repr(value)
    return text if len(text) <= 60 else f"{text[:57]}..."


def unknown_unit(values: Mapping[str, Any], scope: Scope) -> Iterator[Problem]:
    """That the unit is none, which can be told without a datatype."""
    name = values.get("unit")
    if name is not None and scope.vocabulary.unit(name) is None:
        known = dict.fromkeys(unit.key for unit in scope.vocabulary.distinct_units)
        yield Problem(codes.UNIT_UNKNOWN, "unit", f"{name!r} is no unit.", did_you_mean(name, known))


def _unit_problems(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    yield from unknown_unit(values, scope)
    unit = scope.vocabulary.unit(values["unit"]) if values.get("unit") is not None else None
    if unit is None:
        return
    if datatype not in DATATYPES:
        yield Problem(codes.UNIT_OF_WRONG_DATATYPE, "unit", f"A struct such as {datatype} has no unit.", "Remove it.")
    elif not any(belongs_to(element_of(datatype), allowed) for allowed in unit.allowed_datatypes):
        allowed = ", ".join(unit.allowed_datatypes)
        message = f"Unit {unit.key!r} is not for {datatype}; it allows {allowed or 'none'}."
        fix = (
            "Change one of the two." if allowed else f"Give {unit.key!r} its `allowed-datatypes`, in the file of units."
        )
        yield Problem(codes.UNIT_OF_WRONG_DATATYPE, "unit", message, fix)


def _conflicts(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    bounded = values.get("min") is not None or values.get("max") is not None
    if values.get("allowed") and values.get("enum"):
        yield Problem(
            codes.RESTRICTIONS_EXCLUDE_EACH_OTHER,
            "enum",
            "`allowed` and `enum` exclude each other.",
            "Keep one of them.",
        )
    if bounded and values.get("allowed") is not None:
        yield Problem(
            codes.RESTRICTIONS_EXCLUDE_EACH_OTHER,
            "allowed",
            "`allowed` and `min`/`max` exclude each other.",
            "Keep one of them.",
        )
    if bounded and values.get("enum") is not None:
        yield Problem(
            codes.RESTRICTIONS_EXCLUDE_EACH_OTHER,
            "enum",
            "`enum` and `min`/`max` exclude each other.",
            "Keep one of them.",
        )
    if values.get("arraysize") is not None and not is_array(datatype):
        yield Problem(
            codes.ARRAYSIZE_WITHOUT_ARRAY,
            "arraysize",
            f"`arraysize` is for arrays; {datatype} is none.",
            f"Remove it, or write {datatype}[].",
        )


def _range_problems(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    for name in ("min", "max"):
        bound = values.get(name)
        if bound is None:
            continue
        if datatype not in DATATYPES:
            yield Problem(
                codes.LIMIT_OUTSIDE_DATATYPE, name, f"A struct such as {datatype} has no `{name}`.", "Remove it."
            )
        elif not holds(datatype, bound):
            yield Problem(
                codes.LIMIT_OUTSIDE_DATATYPE,
                name,
                f"`{name}` {bound} is no value of {datatype}.",
                "Change the limit, or the datatype.",
            )


def _enum_problems(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    enum = values.get("enum")
    if not enum:
        return
    if datatype not in DATATYPES or not belongs_to(element_of(datatype), "int"):
        yield Problem(
            codes.ENUM_INVALID, "enum", f"`enum` needs an integer datatype, not {datatype}.", "Use one such as uint8."
        )
        return
    if len(set(enum.values())) < len(enum):
        yield Problem(codes.ENUM_INVALID, "enum", "Two names of the `enum` have the same number.", "Give each its own.")
    for i, (key, number) in enumerate(enum.items()):
        if not isinstance(key, str):
            fix = _QUOTE if isinstance(key, bool) else "Quote it."
            yield Problem(codes.ENUM_INVALID, "enum", f"Name {key!r} of the `enum` is no text.", fix, within=(i,))
        elif not re.match(r"[A-Z]", key):
            message = f"Name {key!r} of the `enum` does not start with a capital letter."
            proposal = screaming_snake_case(key)
            fix = f"Write {proposal!r}." if re.match(r"[A-Z]", proposal) else "Start it with a capital letter."
            yield Problem(codes.ENUM_INVALID, "enum", message, fix, within=(i,))
        if not holds(element_of(datatype), number):
            message = f"Number {number} of the `enum` is no value of {datatype}."
            yield Problem(codes.ENUM_INVALID, "enum", message, within=(i,))


def _allowed_problems(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    allowed = values.get("allowed")
    if not allowed:
        return
    if datatype not in DATATYPES:
        yield Problem(
            codes.ALLOWED_OF_WRONG_DATATYPE,
            "allowed",
            f"A struct such as {datatype} has no `allowed` values.",
            "Remove them.",
        )
        return
    for i, value in enumerate(allowed):
        if not holds(datatype, value):
            fix = _QUOTE if isinstance(value, bool) else ""
            message = f"Allowed value {shown(value)} is no value of {datatype}."
            yield Problem(codes.ALLOWED_OF_WRONG_DATATYPE, "allowed", message, fix, within=(i,))


def _default_problems(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    default = values.get("default")
    if default is None:
        return
    if isinstance(default, list) != is_array(datatype):
        needed = "a list" if is_array(datatype) else "a single value"
        yield Problem(
            codes.DEFAULT_OF_WRONG_DATATYPE,
            "default",
            f"Default {shown(default)} does not fit {datatype}, which takes {needed}.",
        )
        return
    size = values.get("arraysize")
    if is_array(datatype) and size and len(default) != size:
        yield Problem(
            codes.DEFAULT_OF_WRONG_DATATYPE,
            "default",
            f"The default has {len(default)} elements, `arraysize` says {size}.",
        )
    items = default if isinstance(default, list) else [default]
    wrong = next((item for item in items if not _fits(item, datatype, scope)), None)
    if wrong is not None:
        yield Problem(
            codes.DEFAULT_OF_WRONG_DATATYPE,
            "default",
            f"Default {shown(wrong)} is no value of {datatype}.",
            _number_of(wrong, values),
        )
        return
    yield from _default_bounds(values, items)


def _default_bounds(values: Mapping[str, Any], items: list[Any]) -> Iterator[Problem]:
    low, high = values.get("min"), values.get("max")
    allowed, enum = values.get("allowed"), values.get("enum")
    for item in items:
        if isinstance(item, int | float):
            if low is not None and item < low - _EPSILON:
                yield Problem(
                    codes.DEFAULT_OUTSIDE_RANGE, "default", f"Default {item} is below `min` {low}.", _INTO_RANGE
                )
            if high is not None and item > high + _EPSILON:
                yield Problem(
                    codes.DEFAULT_OUTSIDE_RANGE, "default", f"Default {item} is above `max` {high}.", _INTO_RANGE
                )
        if values["default"] and allowed and item not in allowed:
            fix = did_you_mean(str(item), [str(value) for value in allowed]) or f"Use one of {shown(allowed)[1:-1]}."
            yield Problem(
                codes.DEFAULT_NOT_ALLOWED, "default", f"Default {shown(item)} is not among the `allowed` values.", fix
            )
        if values["default"] and enum and item not in enum.values():
            yield Problem(
                codes.DEFAULT_NOT_ALLOWED,
                "default",
                f"Default {shown(item)} is no number of the `enum`.",
                _number_of(item, values),
            )


def _number_of(default: Any, values: Mapping[str, Any]) -> str:
    """What to write in place of a default that is a name of the enumeration, or none of its numbers."""
    enum = values.get("enum")
    if not isinstance(enum, Mapping) or not enum:
        return ""
    return (
        f"Write the number, {enum[default]}."
        if default in enum
        else f"Use one of {shown(list(dict.fromkeys(enum.values())))[1:-1]}."
    )


def _fits(value: Any, datatype: str, scope: Scope) -> bool:
    """Whether a default fits its datatype; of a struct, whether it has every property with a fitting value."""
    if datatype in DATATYPES:
        return holds(datatype, value)
    properties = scope.structs.get(element_of(datatype), {})
    items = value if isinstance(value, list) else [value]
    return all(
        isinstance(item, dict) and all(name in item and _json_fits(item[name], d, scope) for name, d in properties.items())
        for item in items
    )  # fmt: skip


def _json_fits(value: Any, definition: Definition, scope: Scope) -> bool:
    datatype = str(definition.values.get("datatype", ""))
    items = value if isinstance(value, list) else [value]
    if is_array(datatype) and not isinstance(value, list):
        return False
    name = element_of(datatype)
    if name not in DATATYPES:
        return _fits(items, name, scope)
    expected: Any = bool if name == "boolean" else str if name == "string" else int | float
    return all(isinstance(item, expected) and (name == "boolean" or not isinstance(item, bool)) for item in items)


def _pattern_problems(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    pattern = values.get("pattern")
    if not pattern:
        return
    if datatype not in ("string", "string[]"):
        yield Problem(codes.PATTERN_NOT_MET, "pattern", f"`pattern` is for strings, not for {datatype}.", "Remove it.")
        return
    if values.get("enum") is not None:
        yield Problem(codes.PATTERN_NOT_MET, "pattern", "`pattern` and `enum` exclude each other.", "Keep one of them.")
    for name in ("default", "allowed"):
        given = values.get(name)
        for item in given if isinstance(given, list) else [given] if given else []:
            reason = scope.matching.mismatch(pattern, item) if isinstance(item, str) else ""
            if reason:
                yield Problem(
                    codes.PATTERN_NOT_MET,
                    name,
                    f"{shown(item)} {reason} `pattern` {pattern!r}.",
                    "Change one of the two.",
                )


_DATA_CHECKS = (
    (frozenset(("unit",)), _unit_problems),
    (frozenset(("min", "max", "allowed", "enum", "arraysize")), _conflicts),
    (frozenset(("min", "max")), _range_problems),
    (frozenset(("enum",)), _enum_problems),
    (frozenset(("allowed",)), _allowed_problems),
    (frozenset(("default",)), _default_problems),
    (frozenset(("pattern",)), _pattern_problems),
)
"""Each check, and the attributes without which it has nothing to say."""
