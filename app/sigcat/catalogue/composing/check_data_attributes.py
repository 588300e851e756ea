"""Check the attributes of sensors, actuators, attributes and properties: units, ranges, defaults, patterns."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import islice
from math import isfinite
from typing import Any

from sigcat import codes
from sigcat.catalogue.composing.attribute_values import NO_VALUE, hashed, number
from sigcat.catalogue.model.datatypes import (
    DATATYPES,
    belongs_to,
    element_of,
    holds,
    is_array,
    is_numeric,
    values_in_words,
)
from sigcat.catalogue.model.definition import Definition, Problem, Scope
from sigcat.catalogue.reading.yaml_scalars import is_read_as_text, number_advice, quote_it, yaml_number
from sigcat.findings import RuleCode, shown
from sigcat.names import did_you_mean, screaming_snake_case

_EPSILON = 1e-6
_SHOWN = 100
"""Values of an enumeration of which a proposal shows the first ones."""


def data_problems(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    """Problems of the attributes of a node with a known datatype, given by its full name."""
    for attributes, check in _CHECKS:
        if not attributes.isdisjoint(values):
            yield from check(values, datatype, scope)


def unit_problems(values: Mapping[str, Any], scope: Scope) -> Iterator[Problem]:
    """The unit is not known. Needs no datatype. Where no unit is known, there is one finding for the tree."""
    name, vocabulary = values.get("unit"), scope.vocabulary
    if name is not None and vocabulary.units and vocabulary.is_unknown(name):
        from sigcat.catalogue.model.near_units import advice  # its tables take time at start-up

        yield Problem(codes.UNIT_UNKNOWN, "unit", f"Unknown unit {name!r}.", advice(name, vocabulary))


def _does_not_fit(value: str, datatype: str) -> str:
    """The message that a value does not fit its datatype, whose values are listed where they are known."""
    return f"{value} does not fit {datatype}{f' ({values_in_words(datatype)})' if datatype in DATATYPES else ''}."


def _not_for_structs(rule: RuleCode, attribute: str, datatype: str) -> Problem:
    return Problem(rule, attribute, f"A struct such as {datatype} cannot have `{attribute}`.", f"Remove `{attribute}`.")


def _check_unit(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    yield from unit_problems(values, scope)
    unit = scope.vocabulary.unit(values["unit"]) if values.get("unit") is not None else None
    if unit is None:
        return
    if datatype not in DATATYPES:
        yield _not_for_structs(codes.UNIT_OF_WRONG_DATATYPE, "unit", datatype)
    elif not any(belongs_to(element_of(datatype), allowed) for allowed in unit.allowed_datatypes):
        allowed = ", ".join(unit.allowed_datatypes)
        message = f"Unit {unit.key!r} does not fit {datatype}; it allows {allowed or 'no datatype'}."
        define = f"Give {unit.key!r} its `allowed-datatypes` in the units file."
        yield Problem(codes.UNIT_OF_WRONG_DATATYPE, "unit", message, "Change one of the two." if allowed else define)


def _check_conflicts(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    bounded = values.get("min") is not None or values.get("max") is not None
    if values.get("allowed") and values.get("enum"):
        yield _conflict(codes.RESTRICTIONS_EXCLUDE_EACH_OTHER, "enum", "`allowed` and `enum`")
    if bounded and values.get("allowed") is not None:
        yield _conflict(codes.RESTRICTIONS_EXCLUDE_EACH_OTHER, "allowed", "`allowed` and `min`/`max`")
    if bounded and values.get("enum") is not None:
        yield _conflict(codes.RESTRICTIONS_EXCLUDE_EACH_OTHER, "enum", "`enum` and `min`/`max`")
    size = values.get("arraysize")
    if size is not None and size < 1:
        message, fix = f"`arraysize` must be 1 or more, not {size}.", "Remove it for an array of any length."
        yield Problem(codes.ARRAY_SIZE_NOT_POSITIVE, "arraysize", message, fix)
    if size is not None and not is_array(datatype):
        message = f"`arraysize` needs an array datatype, not {datatype}."
        yield Problem(codes.ARRAYSIZE_WITHOUT_ARRAY, "arraysize", message, f"Remove it, or write {datatype}[].")


def _conflict(rule: RuleCode, attribute: str, both: str) -> Problem:
    return Problem(rule, attribute, f"{both} exclude each other.", "Keep one of them.")


def _check_range(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    for name in ("min", "max"):
        bound = values.get(name)
        if bound is None:
            continue
        if datatype not in DATATYPES:
            yield _not_for_structs(codes.LIMIT_OUTSIDE_DATATYPE, name, datatype)
        elif not holds(datatype, bound):
            message = _does_not_fit(f"`{name}` {bound}", datatype)
            yield Problem(
                _broken(codes.LIMIT_OUTSIDE_DATATYPE, datatype, bound),
                name,
                message,
                "Change the limit, or the datatype.",
            )


def _broken(rule: RuleCode, datatype: str, value: Any) -> RuleCode:
    """The rule that a value breaks: a number that is infinite as a float breaks that of finite numbers."""
    is_infinite = element_of(datatype) == "float" and type(value) in (int, float) and not holds("float", value)
    return codes.NUMBER_NOT_FINITE if is_infinite else rule


def _equal_numbers(enum: Mapping[str, Any]) -> Iterator[Problem]:
    names: dict[Any, str] = {}
    for i, (name, value) in enumerate(enum.items()):
        if names.setdefault(value, name) != name:
            message = f"{names[value]!r} and {name!r} of the `enum` have the same number, {value}."
            yield Problem(codes.ENUM_INVALID, "enum", message, "Give each name its own number.", within=(i,))


def _check_enum(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    enum = values.get("enum")
    if not enum:
        return
    if datatype not in DATATYPES or not belongs_to(element_of(datatype), "int"):
        message = f"`enum` needs an integer datatype, not {datatype}."
        yield Problem(codes.ENUM_INVALID, "enum", message, "Use one such as uint8.")
        return
    yield from _equal_numbers(enum)
    for i, (key, value) in enumerate(enum.items()):
        yield from _check_enum_name(key, i)
        if not holds(element_of(datatype), value):
            message = _does_not_fit(f"Number {value} of the `enum`", datatype)
            yield Problem(codes.ENUM_INVALID, "enum", message, within=(i,))


def _check_enum_name(name: Any, index: int) -> Iterator[Problem]:
    if not isinstance(name, str):
        message = f"A name of the `enum` must be text, not {shown(name)}."
        yield Problem(codes.ENUM_INVALID, "enum", message, quote_it(name) or "Quote it.", (index,))
    elif not re.match(r"[A-Z]", name):
        proposal = screaming_snake_case(name)
        fix = f"Write {proposal!r}." if re.match(r"[A-Z]", proposal) else "Start it with a capital letter."
        message = f"Name {name!r} of the `enum` must start with a capital letter."
        yield Problem(codes.ENUM_INVALID, "enum", message, fix, (index,))


def _check_allowed(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    allowed = values.get("allowed")
    if not allowed:
        return
    if datatype not in DATATYPES:
        yield _not_for_structs(codes.ALLOWED_OF_WRONG_DATATYPE, "allowed", datatype)
        return
    yield from _booleans("allowed", allowed, datatype)
    for i, value in enumerate(allowed):
        if not holds(datatype, value):
            fix = _spelled(value, datatype)
            message = _does_not_fit(f"Allowed value {shown(value)}", datatype)
            rule = _broken(codes.ALLOWED_OF_WRONG_DATATYPE, datatype, value)
            yield Problem(rule, "allowed", message, fix, within=(i,))


def _check_default(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    default = values.get("default")
    if default is None:
        return
    if isinstance(default, list) != is_array(datatype):
        needed = "a list" if is_array(datatype) else "a single value"
        message = f"The default of {datatype} must be {needed}, not {shown(default)}."
        yield Problem(codes.DEFAULT_OF_WRONG_DATATYPE, "default", message)
        return
    size = values.get("arraysize")
    if is_array(datatype) and size and len(default) != size:
        message = f"The default must have {size} elements, as `arraysize` says, not {len(default)}."
        yield Problem(codes.DEFAULT_OF_WRONG_DATATYPE, "default", message)
    items = default if isinstance(default, list) else [default]
    wrong = next((item for item in items if not _fits(item, datatype, scope)), None)
    if wrong is not None:
        message = _does_not_fit(f"Default {shown(wrong)}", datatype)
        fix = _number_instead(wrong, values) or _spelled(wrong, datatype)
        yield Problem(_broken(codes.DEFAULT_OF_WRONG_DATATYPE, datatype, wrong), "default", message, fix)
        return
    yield from _booleans("default", items, datatype)
    for item in items:
        yield from _check_default_range(values, item)
    if default:  # vss-tools does not compare one that is empty or 0 either
        yield from _check_default_among(values, items)


def _booleans(attribute: str, items: Iterable[Any], datatype: str) -> Iterator[Problem]:
    """True and false in place of numbers: vss-tools takes them for 1 and 0."""
    first = next((item for item in items if isinstance(item, bool)), None)
    if first is not None and is_numeric(datatype):
        message = f"`{attribute}` of {datatype} must be a number, not {str(first).lower()}."
        fix = f"Write {int(first)}, or use boolean as the datatype."
        yield Problem(codes.VALUE_MISSPELLED, attribute, message, fix)


def _check_default_range(values: Mapping[str, Any], item: Any) -> Iterator[Problem]:
    low, high = values.get("min"), values.get("max")
    fix = "Change the default, or the range."
    if isinstance(item, int | float) and low is not None and item < low - _EPSILON:
        yield Problem(codes.DEFAULT_OUTSIDE_RANGE, "default", f"Default {item} is below `min` {low}.", fix)
    if isinstance(item, int | float) and high is not None and item > high + _EPSILON:
        yield Problem(codes.DEFAULT_OUTSIDE_RANGE, "default", f"Default {item} is above `max` {high}.", fix)


def _check_default_among(values: Mapping[str, Any], items: Sequence[Any]) -> Iterator[Problem]:
    allowed, enum = values.get("allowed") or (), values.get("enum") or {}
    for item in _not_among(allowed, items) if allowed else ():
        fix = did_you_mean(str(item), map(str, allowed)) or f"Use one of {shown(allowed)[1:-1]}."
        message = f"Default {shown(item)} is not one of the `allowed` values."
        yield Problem(codes.DEFAULT_NOT_ALLOWED, "default", message, fix)
    for item in _not_among(enum.values(), items) if enum else ():
        message = f"Default {shown(item)} is not a number of the `enum`."
        yield Problem(codes.DEFAULT_NOT_ALLOWED, "default", message, _number_instead(item, values))


def _not_among(known: Iterable[Any], items: Iterable[Any]) -> Iterator[Any]:
    """Items that are equal to none of the known ones."""
    among = set(map(hashed, known))
    return (item for item in items if hashed(item) not in among)


def _number_instead(default: Any, values: Mapping[str, Any]) -> str:
    """Return the replacement of a default that is a name of the enumeration, or not one of its numbers."""
    enum = values.get("enum")
    if not isinstance(enum, Mapping) or not enum:
        return ""
    if isinstance(default, str) and default in enum:
        return f"Write the number, {enum[default]}."
    return f"Use one of {shown(list(dict.fromkeys(islice(enum.values(), _SHOWN))))[1:-1]}."


def _spelled(value: Any, datatype: str) -> str:
    """Return the spelling of a value that YAML reads as another: a text as a number, or a number such as 1e3 as text."""
    meant = number(value) if isinstance(value, str) and is_numeric(datatype) else NO_VALUE
    if meant is not NO_VALUE:
        is_whole = isfinite(meant) and meant == int(meant) and belongs_to(element_of(datatype), "int")
        if is_read_as_text(value):
            return number_advice(value, is_whole=is_whole)
        return f"Write {int(meant) if is_whole else yaml_number(meant)}, without quotes."
    if isinstance(value, str) and is_numeric(datatype):
        return number_advice(value)
    return quote_it(value) if isinstance(value, bool) or element_of(datatype) == "string" else ""


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


def _check_pattern(values: Mapping[str, Any], datatype: str, scope: Scope) -> Iterator[Problem]:
    pattern = values.get("pattern")
    if not pattern:
        return
    if datatype not in ("string", "string[]"):
        message = f"`pattern` needs a string datatype, not {datatype}."
        yield Problem(codes.PATTERN_NOT_MET, "pattern", message, "Remove `pattern`.")
        return
    if values.get("enum") is not None:
        yield _conflict(codes.PATTERN_NOT_MET, "pattern", "`pattern` and `enum`")
    for name in ("default", "allowed"):
        given = values.get(name)
        for item in given if isinstance(given, list) else [given] if given else []:
            mismatch = scope.matching.mismatch(pattern, item) if isinstance(item, str) else ""
            if mismatch:
                message = f"{shown(item)} {mismatch} `pattern` {pattern!r}."
                yield Problem(codes.PATTERN_NOT_MET, name, message, "Change one of the two.")
    if not values.get("default") and not values.get("allowed"):
        yield from _check_pattern_alone(pattern)


def _check_pattern_alone(pattern: str) -> Iterator[Problem]:
    """A pattern that nothing is matched with is compiled all the same."""
    try:
        re.compile(pattern)
    except (re.error, OverflowError, RecursionError) as error:
        message = f"`pattern` must be a regular expression, not {shown(pattern)}: {error}."
        yield Problem(codes.PATTERN_INVALID, "pattern", message)


_CHECKS = (
    (frozenset(("unit",)), _check_unit),
    (frozenset(("min", "max", "allowed", "enum", "arraysize")), _check_conflicts),
    (frozenset(("min", "max")), _check_range),
    (frozenset(("enum",)), _check_enum),
    (frozenset(("allowed",)), _check_allowed),
    (frozenset(("default",)), _check_default),
    (frozenset(("pattern",)), _check_pattern),
)
"""Each check, and the attributes without which it has nothing to check."""
