"""Checks of tables of fields: which fields an interface has to have, and what each may hold.

A table is a mapping of field names to records with `required`, `datatype` (text, number, integer, boolean, value,
list, mapping), `unit`, `values`, `min`, `max`, `pattern` and, for a mapping, `fields` of its own.
"""

from collections.abc import Callable, Iterator, Mapping
from typing import Any, NamedTuple

from sigcat.catalogue.model.definition import CORE_ATTRIBUTES, Definition
from sigcat.findings import shown
from sigcat.names import did_you_mean
from sigcat.rules.checks.attributes import is_empty
from sigcat.rules.checks.kind import BadOption, NodeTest, either, is_number
from sigcat.rules.patterns import Pattern, compile_pattern
from sigcat.rules.problem import Problem, Repair
from sigcat.rules.record import Rule
from sigcat.rules.tree import Tree

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
_KEYS = frozenset(
    ("required", "datatype", "unit", "values", "min", "max", "pattern", "fields", "description", "repairs", "title")
)


def required_fields(rule: Rule, _tree: Tree) -> NodeTest:
    """Every field that the table requires is there."""
    needed = tuple(name for name, field in _table(rule.options["fields"]).items() if field.get("required"))
    table = rule.options["fields"]

    def test(definition: Definition) -> Iterator[Problem]:
        for name in needed:
            if is_empty(definition.values.get(name)):
                unit = f" in {table[name]['unit']}" if "unit" in table[name] else ""
                key = definition.spelled(name)
                message = f"The interface has no `{key}`."
                facts = {"attribute": name}
                yield Problem(definition, message, "", f"Add `{key}`{unit}.", facts)
        yield from _nested_missing(definition, table)

    return test


def field_values(rule: Rule, _tree: Tree) -> NodeTest:
    """Every field of the table that is there has a value of its datatype, among its values and in its range.

    What VSS itself says of its own attributes is found while composing (V004 and others) and not said twice.
    """
    table = _table(rule.options["fields"])
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
    """What is wrong with a value, and the steps that lead to the wrong part of it."""

    message: str
    fix: str = ""
    repair: Repair | None = None
    within: tuple[int | str, ...] = ()
    at_key: bool = False


def _table(fields: Any) -> Mapping[str, Mapping[str, Any]]:
    for name, field in fields.items():
        if not isinstance(field, dict):
            raise BadOption(f"Field {name!r} must be a mapping, not {shown(field)}.")
        for key in field:
            if key not in _KEYS:
                raise BadOption(f"Unknown key {key!r} of field {name!r}.", did_you_mean(str(key), _KEYS))
        if field.get("datatype", "value") not in _DATATYPES:
            given = shown(field["datatype"])
            raise BadOption(f"The datatype of field {name!r} must be {either(_DATATYPES)}, not {given}.")
    table: Mapping[str, Mapping[str, Any]] = fields
    return table


_ABSENT = object()


def _nested_missing(definition: Definition, table: Mapping[str, Any]) -> Iterator[Problem]:
    for name, field in table.items():
        value = definition.values.get(name, _ABSENT)
        if "fields" not in field or not isinstance(value, dict | None):
            continue
        for inner, inner_field in _table(field["fields"]).items():
            if inner_field.get("required") and is_empty((value or {}).get(inner)):
                message = f"`{name}` has no `{inner}`."
                yield Problem(definition, message, name, f"Add `{inner}` to `{name}`.", {"attribute": inner})


def _value_test(name: str, field: Mapping[str, Any], rule: Rule) -> Callable[[Any], Iterator[_Wrong]]:
    datatype = field.get("datatype", "value")
    fits = _DATATYPES[datatype]
    pattern = compile_pattern(field["pattern"], trusted=rule.trusted) if "pattern" in field else None
    inner = {key: _value_test(f"{name}.{key}", value, rule) for key, value in _table(field.get("fields", {})).items()}

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
    """What a field takes, as a message names it: `a number from 0 to 100 in ms`."""
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
