"""Checks of tables of fields: which fields an interface has to have, and what each may hold.

A table is a mapping of field names to records with `required`, `datatype` (text, number, integer, boolean, value,
list, mapping), `unit`, `values`, `min`, `max`, `pattern` and, for a mapping, its own `fields`.
"""

from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

from sigcat.catalogue.model.definition import CORE_ATTRIBUTES, Definition
from sigcat.findings import shown
from sigcat.names import did_you_mean, either
from sigcat.rules.checks.attributes import is_empty
from sigcat.rules.checks.kind import BadOption, Kind, NodeTest, is_number
from sigcat.rules.patterns import Pattern, compile_pattern
from sigcat.rules.problem import Problem, Repair
from sigcat.rules.record import Rule
from sigcat.rules.tree import Tree

Table = Mapping[str, Mapping[str, Any]]
"""Records of fields by name."""

_DATATYPES: Mapping[str, Callable[[Any], bool]] = {
    "text": lambda value: isinstance(value, str),
    "number": is_number,
    "integer": lambda value: isinstance(value, int) and not isinstance(value, bool),
    "boolean": lambda value: isinstance(value, bool),
    "value": lambda value: not isinstance(value, dict),
    "list": lambda value: isinstance(value, list),
    "text or list": lambda value: isinstance(value, str | list),
    "mapping": lambda value: isinstance(value, dict),
}


def _is_list_of_values(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and all(isinstance(item, str | int | float) for item in value)


def _is_repairs(value: Any) -> bool:
    return isinstance(value, dict) and all(isinstance(text, str) for text in (*value, *value.values()))


_KEYS: Mapping[str, tuple[str, Callable[[Any], bool]]] = {
    "required": ("true or false", _DATATYPES["boolean"]),
    "datatype": (either(_DATATYPES), lambda value: isinstance(value, str) and value in _DATATYPES),
    "unit": ("a text", _DATATYPES["text"]),
    "values": ("a list of at least one text, number or boolean", _is_list_of_values),
    "min": ("a number", is_number),
    "max": ("a number", is_number),
    "pattern": ("a text", _DATATYPES["text"]),
    "fields": ("a mapping", _DATATYPES["mapping"]),
    "description": ("a text", _DATATYPES["text"]),
    "title": ("a text", _DATATYPES["text"]),
    "repairs": ("a mapping of texts to texts", _is_repairs),
}
"""Keys of the record of a field, each with the check of its value."""


def _check_table(option: str, fields: Any) -> None:
    """Raises BadOption if this is not a table of fields, for any error at any depth."""
    if not isinstance(fields, dict):
        raise BadOption(f"{option} must be a mapping, not {shown(fields)}.")
    for name, field in fields.items():
        if not isinstance(name, str) or not name.strip():
            raise BadOption(f"The name of a field must be a text, not {shown(name)}.")
        if not isinstance(field, dict):
            raise BadOption(f"Field {name!r} must be a mapping, not {shown(field)}.")
        for key, value in field.items():
            if key not in _KEYS:
                raise BadOption(f"Unknown key {key!r} of field {name!r}.", did_you_mean(str(key), _KEYS))
            expected, fits = _KEYS[key]
            if not fits(value):
                raise BadOption(f"`{key}` of field {name!r} must be {expected}, not {shown(value)}.")
        _check_table(option, field.get("fields", {}))


FIELDS: Kind = Kind("table of fields", _check_table)


def required_fields(rule: Rule, _tree: Tree) -> NodeTest:
    """Every field that the table requires is there, within fields too."""
    table: Table = rule.options["fields"]

    def test(definition: Definition) -> Iterator[Problem]:
        for name, field in table.items():
            if field.get("required") and is_empty(definition.values.get(name)):
                unit = f" in {field['unit']}" if "unit" in field else ""
                key = definition.spelled(name)
                message = f"The interface has no `{key}`."
                yield Problem(definition, message, "", f"Add `{key}`{unit}.", {"attribute": name})
        for name, field in table.items():
            for outer, missing, within in _missing_within(name, field, definition.values.get(name, _ABSENT)):
                message = f"`{outer}` has no `{missing}`."
                fix, facts = f"Add `{missing}` to `{outer}`.", {"attribute": missing}
                yield Problem(definition, message, name, fix, facts, within=within)

    return test


_ABSENT = object()


def _missing_within(
    name: str, field: Mapping[str, Any], value: Any, within: tuple[int | str, ...] = ()
) -> Iterator[tuple[str, str, tuple[int | str, ...]]]:
    """The fields that are missing in the mapping of a field: that of which one, its name, and the steps to the mapping."""
    if not isinstance(value, dict | None):
        return
    given = value or {}
    for inner, record in field.get("fields", {}).items():
        if record.get("required") and is_empty(given.get(inner)):
            yield name, inner, within
        yield from _missing_within(f"{name}.{inner}", record, given.get(inner, _ABSENT), (*within, inner))


def field_values(rule: Rule, _tree: Tree) -> NodeTest:
    """Every field of the table that is there has a value of its datatype, among its values and in its range.

    Errors in attributes of VSS are found while composing (V004 and others) and not reported twice.
    """
    table: Table = rule.options["fields"]
    judged = {name: field for name, field in table.items() if name not in CORE_ATTRIBUTES or "values" in field}
    tests = {name: _value_test(name, field, rule) for name, field in judged.items()}

    def test(definition: Definition) -> Iterator[Problem]:
        for name, value in definition.values.items():
            if name in tests and value is not None:
                facts = {"attribute": name, "value": value}
                for wrong in tests[name](value):
                    yield Problem(
                        definition, wrong.message, name, wrong.fix, facts, wrong.repair, wrong.at_key, wrong.within
                    )

    return test


class _Wrong(NamedTuple):
    """Yield the problems of a value, with the steps to the wrong part of it."""

    message: str
    fix: str = ""
    repair: Repair | None = None
    within: tuple[int | str, ...] = ()
    at_key: bool = False


def _value_test(name: str, field: Mapping[str, Any], rule: Rule) -> Callable[[Any], Iterator[_Wrong]]:
    datatype = field.get("datatype", "value")
    fits = _DATATYPES[datatype]
    pattern = compile_pattern(field["pattern"], trusted=rule.trusted) if "pattern" in field else None
    inner = {key: _value_test(f"{name}.{key}", value, rule) for key, value in field.get("fields", {}).items()}

    def test(value: Any) -> Iterator[_Wrong]:
        if not fits(value):
            yield _Wrong(f"`{name}` must be {_expected(field)}, not {shown(value)}.")
        elif isinstance(value, dict):
            yield from _wrong_inner(name, inner, value)
        elif isinstance(value, list):
            for i, item in enumerate(value):
                yield from (wrong._replace(within=(i,)) for wrong in _wrong_item(name, field, item, pattern))
                if "values" in field and item in value[:i]:
                    yield _Wrong(f"`{name}` must have {shown(item)} once.", "Remove the second one.", within=(i,))
        else:
            yield from _wrong_item(name, field, value, pattern)

    return test


def _wrong_item(name: str, field: Mapping[str, Any], item: Any, pattern: Pattern | None) -> Iterator[_Wrong]:
    values = field.get("values")
    if values is not None and (isinstance(item, list | dict) or item not in values):
        meant = field.get("repairs", {}).get(item) if isinstance(item, str) else None
        only = values[0] if len(values) == 1 else None
        fix = f"Write {meant or only}." if meant or only else did_you_mean(str(item), map(str, values))
        message = f"`{name}` must be {either(values)}, not {shown(item)}."
        yield _Wrong(message, fix, meant and Repair("replace", meant))
    elif pattern is not None and not (isinstance(item, str) and pattern.matches(item)):
        yield _Wrong(f"`{name}` must match {pattern.text}; {shown(item)} does not.")
    elif is_number(item) and not _is_in_range(item, field):
        yield _Wrong(f"`{name}` must be {_expected(field)}, not {item}.")


def _is_in_range(number: float, field: Mapping[str, Any]) -> bool:
    low, high = field.get("min"), field.get("max")
    return (low is None or number >= low) and (high is None or number <= high)


def _wrong_inner(
    name: str, inner: Mapping[str, Callable[[Any], Iterator[_Wrong]]], value: Mapping[str, Any]
) -> Iterator[_Wrong]:
    for key, item in value.items():
        if key not in inner and inner:
            message = f"Unknown field {key!r} in `{name}`."
            yield _Wrong(message, did_you_mean(str(key), inner), within=(str(key),), at_key=True)
        elif key in inner and item is not None:
            yield from (wrong._replace(within=(str(key), *wrong.within)) for wrong in inner[key](item))


def _expected(field: Mapping[str, Any]) -> str:
    """Return the accepted values of a field for a message: `a number from 0 to 100 in ms`."""
    if "values" in field:
        return either(field["values"])
    datatype = str(field.get("datatype", "value")).replace(" or ", " or a ")
    unit = f" in {field['unit']}" if "unit" in field else ""
    return f"{'an' if datatype[0] in 'aeiou' else 'a'} {datatype}{_range(field)}{unit}"


def _range(field: Mapping[str, Any]) -> str:
    low, high = field.get("min"), field.get("max")
    if low is not None and high is not None:
        return f" from {low} to {high}"
    return f" of at least {low}" if low is not None else f" of at most {high}" if high is not None else ""
