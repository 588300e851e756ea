"""Blame: a problem that a later statement brought to a value of an earlier one is reported at the later statement."""

from collections.abc import Callable, Iterable, Mapping
from typing import Any

from sigcat.catalogue.composing.check_definition import checked_definition
from sigcat.catalogue.model.definition import Definition, Problem, Scope, merged_statements, merged_values
from sigcat.catalogue.reading.statement import Statement

ProblemsWithout = Callable[[str], Iterable[Problem]]
"""The problems that there would be if the last statement did not give an attribute."""


def with_blame(definition: Definition, before: Definition, scope: Scope) -> Definition:
    """The definition with its new problems blamed on its last statement. `before` is the definition without it."""
    last = definition.statements[-1].values
    known = {(problem.rule, problem.attribute): problem for problem in before.problems}
    problems_without = _problems_without(definition.path, definition.statements, scope)
    problems = []
    for problem in definition.problems:
        earlier = known.get((problem.rule, problem.attribute))
        if earlier is not None:
            problems.append(problem._replace(brought_by=earlier.brought_by))
        elif problem.attribute in last or not last:
            problems.append(problem)
        else:
            problems.append(problem._replace(brought_by=_culprit(problem, last, problems_without)))
    return definition.with_problems(tuple(problems))


def _problems_without(path: str, statements: tuple[Statement, ...], scope: Scope) -> ProblemsWithout:
    *earlier, last = statements

    def problems_without(attribute: str) -> Iterable[Problem]:
        rest = {name: value for name, value in last.values.items() if name != attribute}
        values = merged_values(merged_statements(earlier), rest)
        return checked_definition(path, statements, values, scope).problems

    return problems_without


def _culprit(problem: Problem, last: Mapping[str, Any], problems_without: ProblemsWithout) -> str:
    """The attribute of the last statement without which the problem would not be there."""
    for attribute in last:
        others = problems_without(attribute)
        if not any((other.rule, other.attribute) == (problem.rule, problem.attribute) for other in others):
            return attribute
    return next(iter(last))
