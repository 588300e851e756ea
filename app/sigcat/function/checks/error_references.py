"""References between errors, and from safety reactions to errors."""

from collections.abc import Collection, Iterator

from sigcat import codes
from sigcat.function.checks.circles import Circle, circles
from sigcat.function.document.problem import Problem, Subject
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import contracts, errors
from sigcat.names import did_you_mean

Problems = Iterator[Problem]

_MOST_NAMED = 3
"""Members of a circle that a message names."""


def check_error_references(function: FunctionJson, known_errors: Collection[str]) -> Problems:
    """Every problem of references to errors. `known_errors` are names of errors that others declare."""
    names = dict.fromkeys((*(error.name for _, _, error in errors(function)), *known_errors))
    yield from _of_reactions(function, names, known_errors)
    yield from _of_errors(function, names, known_errors)
    yield from _circles(function)


def _of_reactions(function: FunctionJson, names: Collection[str], known: Collection[str]) -> Problems:
    for pointer, _, contract in contracts(function):
        for i, reaction in enumerate(contract.safety_reactions or ()):
            for j, name in enumerate(reaction.errors):
                if _is_undeclared(name, names, known, function):
                    message = f"{reaction.name} must react to an error that exists, not to {name!r}."
                    at = (*pointer, "SafetyReactionList", i, "ErrorList", j)
                    subject = Subject("safety_reaction", reaction.name, ("errorList",))
                    yield Problem(codes.REACTION_TO_UNKNOWN_ERROR, at, message, did_you_mean(name, names), subject)


def _of_errors(function: FunctionJson, names: Collection[str], known: Collection[str]) -> Problems:
    for pointer, _, error in errors(function):
        for j, name in enumerate(error.dependencies):
            if _is_undeclared(name, names, known, function):
                message = f"{error.name} must depend on an error that exists, not on {name!r}."
                subject = Subject("error", error.name, ("dependency",))
                fix = did_you_mean(name, [each for each in names if each != error.name])
                yield Problem(codes.DEPENDENCY_UNKNOWN, (*pointer, "Dependancy", j), message, fix, subject)


def _is_undeclared(name: str, names: Collection[str], known: Collection[str], function: FunctionJson) -> bool:
    """Errors of others are unknown, and no problem, where no catalogue says what there is."""
    return name not in names and (bool(known) or name.startswith(f"{function.info.function_name}_"))


def _circles(function: FunctionJson) -> Problems:
    following = {error.name: error.dependencies for _, _, error in errors(function)}
    circle_of = circles(following, "error", "dependency")
    for pointer, _, error in errors(function):
        circle = circle_of.get(error.name)
        if circle is not None:
            message = f"{error.name} depends on itself{_through(error.name, circle)}."
            at, subject = (*pointer, "Dependancy"), Subject("error", error.name, ("dependency",))
            fix = "Remove one of the dependencies."
            yield Problem(codes.DEPENDENCIES_IN_A_CIRCLE, at, message, fix, subject, circle=circle)


def _through(name: str, circle: Circle) -> str:
    """The other members of a circle, as the end of a sentence."""
    others = [subject.name for subject in circle if subject.name != name][:_MOST_NAMED]
    return f", through {', '.join(others)}" if others else ""
