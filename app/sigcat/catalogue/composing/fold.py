"""Fold the statements of a node into its definition, normalized and checked.

The checks are those that decide whether vss-tools would take the node; style is the linter's matter. A definition
with problems is kept, so that everything wrong with a tree can be told at once.
"""

import re
from collections.abc import Callable, Iterable, Mapping
from typing import Any

from sigcat import codes
from sigcat.catalogue.composing.attribute_values import CONVERSIONS, EXPECTED, NO_VALUE, text
from sigcat.catalogue.composing.data_problems import data_problems, shown, unknown_unit
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
    overlaid,
)
from sigcat.catalogue.reading.vspec_file import Statement
from sigcat.names import did_you_mean, last_name, parent_path


def define(path: str, statements: tuple[Statement, ...], scope: Scope) -> Definition:
    """Fold statements, first to last, into a checked definition."""
    definition = checked(path, statements, _folded(statements), scope)
    if not definition.problems or len(statements) == 1:
        return definition
    below = define(path, statements[:-1], scope)
    return _blaming(definition, below, _without_last(path, statements, scope))


def blaming(definition: Definition, below: Definition, scope: Scope) -> Definition:
    """The definition, what it has beside the problems of `below` told of the statements that it has beside those."""
    return _blaming(definition, below, _without_last(definition.path, definition.statements, scope))


def _folded(statements: tuple[Statement, ...]) -> Mapping[str, Any]:
    values = statements[0].values
    for statement in statements[1:]:
        values = overlaid(values, statement.values)
    return values


Less = Callable[[str], Iterable[Problem]]
"""Problems that there would be if the last statement did not give an attribute."""


def _without_last(path: str, statements: tuple[Statement, ...], scope: Scope) -> Less:
    last = statements[-1]

    def less(attribute: str) -> Iterable[Problem]:
        rest = {name: value for name, value in last.values.items() if name != attribute}
        return checked(path, statements, overlaid(_folded(statements[:-1]), rest), scope).problems

    return less


def _blaming(definition: Definition, below: Definition, less: Less) -> Definition:
    """Problems that the last statement brought to an attribute of an earlier one, told where it brought them."""
    last = definition.statements[-1].values
    known = {(problem.rule, problem.attribute): problem for problem in below.problems}
    problems = []
    for problem in definition.problems:
        earlier = known.get((problem.rule, problem.attribute))
        if earlier is not None:
            problems.append(problem._replace(brought_by=earlier.brought_by))
        elif problem.attribute in last or not last:
            problems.append(problem)
        else:
            problems.append(problem._replace(brought_by=_culprit(problem, last, less)))
    return Definition(
        definition.path, definition.statements, definition.values, tuple(problems), definition.is_instance
    )


def _culprit(problem: Problem, last: Mapping[str, Any], less: Less) -> str:
    """The attribute of the last statement without which there would be no such problem."""
    for attribute in last:
        if not any((other.rule, other.attribute) == (problem.rule, problem.attribute) for other in less(attribute)):
            return attribute
    return next(iter(last))


def checked(
    path: str,
    statements: tuple[Statement, ...],
    values: Mapping[str, Any],
    scope: Scope,
    is_instance: bool = False,
) -> Definition:
    """A definition of normalized values and all problems of them."""
    problems: list[Problem] = []
    values = _normalized(path, values, scope, problems)
    node_type = values.get("type")
    if node_type not in TYPES:
        problems.append(_wrong_type(node_type))
    elif node_type == BRANCH:
        _check_branch(values, problems)
    elif node_type != STRUCT:
        _check_data(path, values, scope, problems)
    if node_type in TYPES:
        _check_core_attributes(values, problems)
    return Definition(path, statements, values, tuple(problems), is_instance)


def resolved_datatype(datatype: str, path: str, structs: Mapping[str, Any]) -> str | None:
    """The datatype with a struct's name made a full path, or None if there is no such datatype."""
    if datatype in DATATYPES:
        return datatype
    name, suffix = (element_of(datatype), "[]") if is_array(datatype) else (datatype, "")
    near = {last_name(s): s for s in structs if not path.startswith(s) and path.startswith(parent_path(s))}
    full = near.get(name, name if name in structs else None)
    return full + suffix if full else None


def _normalized(path: str, values: Mapping[str, Any], scope: Scope, problems: list[Problem]) -> Mapping[str, Any]:
    """The values as vss-tools holds them: units by canonical key, datatypes by full path, numbers as numbers."""
    changed: dict[str, Any] = {}
    for name, value in values.items():
        convert = CONVERSIONS.get(name)
        if convert is None or value is None or (convert is text and type(value) is str):
            continue
        converted = convert(value)
        if converted is NO_VALUE:
            problems.append(
                Problem(
                    codes.ATTRIBUTE_OF_WRONG_KIND, name, f"{shown(value)} is no value for `{name}`: {EXPECTED[name]}."
                )
            )
        elif converted is not value:
            changed[name] = converted
    unit = values.get("unit")
    if isinstance(unit, str):
        known = scope.vocabulary.units.get(unit.lower())
        if known is not None and known.key != unit:
            changed["unit"] = known.key
    datatype = values.get("datatype")
    if isinstance(datatype, str) and datatype not in DATATYPES:
        resolved = resolved_datatype(datatype, path, scope.structs)
        if resolved is not None and resolved != datatype:
            changed["datatype"] = resolved
    return {**values, **changed} if changed else values


def _wrong_type(node_type: Any) -> Problem:
    if node_type is None:
        return Problem(codes.TYPE_MISSING_OR_UNKNOWN, "", "The node has no `type`.", f"Add one of {', '.join(TYPES)}.")
    fix = did_you_mean(str(node_type), TYPES) or f"Use one of {', '.join(TYPES)}."
    return Problem(codes.TYPE_MISSING_OR_UNKNOWN, "type", f"{shown(node_type)} is no node type.", fix)


def _check_branch(values: Mapping[str, Any], problems: list[Problem]) -> None:
    for steps, entry in labels_of(values):
        match = re.search(r"\[(\d+),(\d+)\](?!.*\[\d+,\d+\])", str(entry))
        if match and int(match[1]) > int(match[2]):
            message = f"Range {match[0]} of {entry!r} runs backwards."
            fix = f"Write [{match[2]},{match[1]}]."
            problems.append(Problem(codes.INSTANCES_RUN_BACKWARDS, "instances", message, fix, within=steps))


def _check_core_attributes(values: Mapping[str, Any], problems: list[Problem]) -> None:
    node_type = values["type"]
    own = BRANCH_ATTRIBUTES if node_type == BRANCH else COMMON_ATTRIBUTES if node_type == STRUCT else DATA_ATTRIBUTES
    if not own.issuperset(values):
        for name in values:
            if name in CORE_ATTRIBUTES and name not in own:
                message = f"`{name}` has no meaning for the node type {node_type}."
                problems.append(Problem(codes.ATTRIBUTE_WITHOUT_MEANING, name, message, "Remove it."))
    uid = values.get("constUID")
    if isinstance(uid, str) and not re.fullmatch(r"0x[0-9A-Fa-f]{8}\n?", uid):
        problems.append(
            Problem(codes.IDENTIFIER_MALFORMED, "constUID", f"{uid!r} is not 0x and eight hexadecimal digits.")
        )


def _check_data(path: str, values: Mapping[str, Any], scope: Scope, problems: list[Problem]) -> None:
    unusable = {problem.attribute for problem in problems if problem.rule.id == codes.ATTRIBUTE_OF_WRONG_KIND.id}
    if "datatype" in unusable:
        return
    values = {name: value for name, value in values.items() if name not in unusable} if unusable else values
    datatype = values.get("datatype")
    if not isinstance(datatype, str):
        problems.append(
            Problem(
                codes.DATATYPE_MISSING, "", "The node has no `datatype`.", "Add one, such as uint8, float or string."
            )
        )
        problems.extend(unknown_unit(values, scope))
        return
    resolved = resolved_datatype(datatype, path, scope.structs)
    if resolved is None:
        fix = did_you_mean(datatype, (*sorted(DATATYPES), *scope.structs))
        problems.append(Problem(codes.DATATYPE_UNKNOWN, "datatype", f"{datatype!r} is no datatype.", fix))
        problems.extend(unknown_unit(values, scope))
        return
    problems.extend(data_problems(values, resolved, scope))
