"""Check the values of a node: merged values in, a normalized definition with its problems out.

The checks are those that decide whether vss-tools would accept the node; style is left to the linter. A definition
with problems is kept, so that everything wrong with a tree can be reported at once.
"""

import re
from collections.abc import Iterator, Mapping
from math import isfinite
from typing import Any

from sigcat import codes
from sigcat.catalogue.composing.attribute_values import (
    CONVERSIONS,
    EXPECTED,
    NO_VALUE,
    is_finite,
    is_fraction,
    is_misspelled,
    text,
    whole_numbers,
)
from sigcat.catalogue.composing.check_data_attributes import data_problems, unit_problems
from sigcat.catalogue.model.datatypes import DATATYPES, element_of, is_array
from sigcat.catalogue.model.definition import (
    BRANCH,
    BRANCH_ATTRIBUTES,
    COMMON_ATTRIBUTES,
    CORE_ATTRIBUTES,
    DATA_ATTRIBUTES,
    STRUCT,
    TYPES,
    Definition,
    Problem,
    Scope,
    labels_of,
)
from sigcat.catalogue.reading.statement import Statement
from sigcat.catalogue.reading.yaml_scalars import is_read_as_text, number_advice, quote_it, yaml_number
from sigcat.findings import shown
from sigcat.names import did_you_mean, did_you_mean_last, last_name, parent_path, with_article


def checked_definition(
    path: str,
    statements: tuple[Statement, ...],
    values: Mapping[str, Any],
    scope: Scope,
    is_instance: bool = False,
) -> Definition:
    """A definition of normalized values, with all problems of them."""
    problems: list[Problem] = []
    values = _normalized(path, values, scope, problems)
    node_type = values.get("type")
    if node_type not in TYPES:
        problems.append(_wrong_type(node_type))
    elif node_type == BRANCH:
        problems.extend(_instance_problems(values))
    elif node_type != STRUCT:
        _check_data(path, values, scope, problems)
    if node_type in TYPES:
        _check_core_attributes(values, problems)
    return Definition(path, statements, values, tuple(problems), is_instance)


def resolved_datatype(datatype: str, path: str, scope: Scope) -> str | None:
    """The datatype with a struct's name made a full path, or None if there is no such datatype."""
    if datatype in DATATYPES:
        return datatype
    name, suffix = (element_of(datatype), "[]") if is_array(datatype) else (datatype, "")
    named = reversed(scope.struct_paths.get(name, ()))
    near = next((s for s in named if not path.startswith(s) and path.startswith(parent_path(s))), None)
    full = near or (name if name in scope.structs else None)
    return full + suffix if full else None


def _normalized(path: str, values: Mapping[str, Any], scope: Scope, problems: list[Problem]) -> Mapping[str, Any]:
    """The values as vss-tools holds them: units by canonical key, datatypes by full path, numbers as numbers."""
    changed: dict[str, Any] = {}
    for name, value in values.items():
        convert = CONVERSIONS.get(name)
        is_as_meant = convert is None or value is None or (convert is text and type(value) is str)
        converted = value if convert is None or is_as_meant else convert(value)
        if converted is NO_VALUE:
            message = f"`{name}` must be {EXPECTED[name]}, not {shown(value)}."
            fix = _in_quotes(value) if convert is text or name == "allowed" else ""
            if name == "allowed" and isinstance(value, str) and value.startswith("-"):
                fix = "Write a space behind each hyphen."
            problems.append(Problem(codes.ATTRIBUTE_OF_WRONG_KIND, name, message, fix))
        elif type(converted) in _MAY_BE_INFINITE and name != "type" and not is_finite(converted):
            message = f"`{name}` must be a finite number, not {shown(value)}."
            problems.append(Problem(codes.NUMBER_NOT_FINITE, name, message, "Remove it: JSON has no such number."))
        if converted is not value and converted is not NO_VALUE:
            changed[name] = converted
    changed.update(whole_numbers({**values, **changed}))
    for name, meant in changed.items():
        problems.extend(_misspelled(name, values[name], meant))
    changed.update(_references_in_full(path, values, scope))
    return {**values, **changed} if changed else values


def _in_quotes(value: Any) -> str:
    items = value if isinstance(value, list) else [value]
    return next((quote_it(item) for item in items if not isinstance(item, str | list | dict)), "")


_MAY_BE_INFINITE = (float, list, dict)


def _misspelled(name: str, written: Any, meant: Any) -> Iterator[Problem]:
    """A value that vss-tools takes for another, `'0'` for 0 and `'yes'` for true, or refuses: 1.0 for 1."""
    if isinstance(meant, float) and not isfinite(meant):
        return  # reported as what JSON does not have
    if is_misspelled(written, meant):
        wrong = f"the text {shown(written)}" if isinstance(written, str) else _yaml_word(written)
        message = f"`{name}` must be {EXPECTED[name]}, not {wrong}."
        fix = f"Write `{name}: {_yaml_word(meant)}`{', without quotes' if isinstance(written, str) else ''}."
        fix = number_advice(written, is_whole=isinstance(meant, int)) if is_read_as_text(written) else fix
        yield Problem(codes.VALUE_MISSPELLED, name, message, fix)
    elif is_fraction(written, meant):
        message = f"`{name}` must be a whole number, not {shown(written)}."
        yield Problem(codes.VALUE_MISSPELLED, name, message, f"Write {shown(meant)}: vss-tools refuses fractions.")


def _yaml_word(value: Any) -> str:
    """A single value as YAML writes it: `true`, not `True`."""
    if isinstance(value, bool):
        return str(value).lower()
    return yaml_number(value) if isinstance(value, float) else str(value)


def _references_in_full(path: str, values: Mapping[str, Any], scope: Scope) -> Iterator[tuple[str, str]]:
    """Unit and datatype under the names that the vocabulary and the struct types give them, where these differ."""
    unit = values.get("unit")
    if isinstance(unit, str):
        known = scope.vocabulary.units.get(unit.lower())
        if known is not None and known.key != unit:
            yield "unit", known.key
    datatype = values.get("datatype")
    if isinstance(datatype, str) and datatype not in DATATYPES:
        resolved = resolved_datatype(datatype, path, scope)
        if resolved is not None and resolved != datatype:
            yield "datatype", resolved


def _wrong_type(node_type: Any) -> Problem:
    one_of = f"one of {', '.join(TYPES)}."
    if node_type is None:
        return Problem(codes.TYPE_MISSING_OR_UNKNOWN, "", "The node has no `type`.", f"Add {one_of}")
    fix = did_you_mean(str(node_type), TYPES) or f"Use {one_of}"
    return Problem(codes.TYPE_MISSING_OR_UNKNOWN, "type", f"{shown(node_type)} is not a node type.", fix)


def _instance_problems(values: Mapping[str, Any]) -> Iterator[Problem]:
    for steps, entry in labels_of(values):
        if isinstance(entry, bool):
            message = f"An instance must be text, not {_yaml_word(entry)}: its path would end with {str(entry)!r}."
            yield Problem(codes.VALUE_MISSPELLED, "instances", message, quote_it(entry), within=steps)
        match = re.search(r"\[ *(\d+) *, *(\d+) *\](?!.*\[\d+,\d+\])", str(entry))
        if match and " " in match[0]:
            message = f"A space keeps {match[0]} of {str(entry)!r} from being a range."
            fix = f"Write {match[0].replace(' ', '')}."
            yield Problem(codes.RANGE_WITH_SPACE, "instances", message, fix, within=steps)
        elif match and int(match[1]) > int(match[2]):
            message = f"Range {match[0]} of {entry!r} runs backwards."
            fix = f"Write [{match[2]},{match[1]}]."
            yield Problem(codes.INSTANCES_RUN_BACKWARDS, "instances", message, fix, within=steps)


def _check_core_attributes(values: Mapping[str, Any], problems: list[Problem]) -> None:
    node_type = values["type"]
    own = BRANCH_ATTRIBUTES if node_type == BRANCH else COMMON_ATTRIBUTES if node_type == STRUCT else DATA_ATTRIBUTES
    if not own.issuperset(values):
        for name in values:
            if name in CORE_ATTRIBUTES and name not in own:
                message = f"`{name}` has no meaning for {with_article(node_type)}."
                problems.append(Problem(codes.ATTRIBUTE_WITHOUT_MEANING, name, message, f"Remove `{name}`."))
    uid = values.get("constUID")
    if isinstance(uid, str) and not re.fullmatch(r"0x[0-9A-Fa-f]{8}\n?", uid):
        message = f"`constUID` must be 0x and eight hexadecimal digits, not {uid!r}."
        problems.append(Problem(codes.IDENTIFIER_MALFORMED, "constUID", message))


def _check_data(path: str, values: Mapping[str, Any], scope: Scope, problems: list[Problem]) -> None:
    """Add the problems of a node with a datatype; what has the wrong kind of value is not checked further."""
    unusable = {problem.attribute for problem in problems if problem.rule.id == codes.ATTRIBUTE_OF_WRONG_KIND.id}
    if "datatype" in unusable:
        return
    values = {name: value for name, value in values.items() if name not in unusable} if unusable else values
    datatype = values.get("datatype")
    resolved = resolved_datatype(datatype, path, scope) if isinstance(datatype, str) else None
    if resolved is not None:
        problems.extend(data_problems(values, resolved, scope))
        return
    problems.append(_wrong_datatype(datatype, scope))
    problems.extend(unit_problems(values, scope))


def _wrong_datatype(datatype: Any, scope: Scope) -> Problem:
    if not isinstance(datatype, str):
        fix = "Add one, such as uint8, float or string."
        return Problem(codes.DATATYPE_MISSING, "", "The node has no `datatype`.", fix)
    fix = (
        did_you_mean(datatype, (*sorted(DATATYPES), *scope.structs))
        or did_you_mean_last(datatype, {struct: last_name(struct) for struct in scope.structs})
        or "Use one such as uint8, float or string, or a struct: list its file as `types` in sigcat.toml, or pass it with -t."
    )
    return Problem(codes.DATATYPE_UNKNOWN, "datatype", f"{datatype!r} is not a datatype.", fix)
