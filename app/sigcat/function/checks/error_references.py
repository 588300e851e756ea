"""References between errors, and from safety reactions to errors."""

from collections.abc import Collection, Iterable
from typing import NamedTuple

from sigcat import codes
from sigcat.function.checks.circles import Circle, circles
from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import errors, safety_reactions
from sigcat.names import did_you_mean

_MOST_NAMED = 3
"""Members of a circle that a message names."""


class KnownErrors(NamedTuple):
    """Names of the errors that the catalogue has."""

    names: frozenset[str]
    own: frozenset[str]
    """Those of the function itself, which one of its calls must report."""


NO_ERRORS = KnownErrors(frozenset(), frozenset())


def check_error_references(function: FunctionJson, known_errors: KnownErrors) -> Problems:
    """Every problem of references to errors."""
    others = known_errors.names - known_errors.own
    names = dict.fromkeys((*(error.name for _, _, error in errors(function)), *sorted(others)))
    yield from _of_reactions(function, names, known_errors)
    yield from _of_errors(function, names, known_errors)
    yield from _circles(function)


def _of_reactions(function: FunctionJson, names: Collection[str], known: KnownErrors) -> Problems:
    for pointer, _, reaction in safety_reactions(function):
        for j, name in enumerate(reaction.errors):
            if _is_undeclared(name, names, known, function):
                message = f"{reaction.name} must react to an error that {_condition(name, known)}, not to {name!r}."
                subject = Subject("safety_reaction", reaction.name, ("errorList",))
                at, fix, cause = (*pointer, "ErrorList", j), _fix(name, names, known), Subject("error", name)
                yield Problem(codes.REACTION_TO_UNKNOWN_ERROR, at, message, fix, subject, cause)


def _of_errors(function: FunctionJson, names: Collection[str], known: KnownErrors) -> Problems:
    for pointer, _, error in errors(function):
        for j, name in enumerate(error.dependencies):
            if _is_undeclared(name, names, known, function):
                message = f"{error.name} must depend on an error that {_condition(name, known)}, not on {name!r}."
                subject = Subject("error", error.name, ("dependency",))
                fix = _fix(name, [each for each in names if each != error.name], known)
                at, cause = (*pointer, "Dependancy", j), Subject("error", name)
                yield Problem(codes.DEPENDENCY_UNKNOWN, at, message, fix, subject, cause=cause)


def _condition(name: str, known: KnownErrors) -> str:
    return "a call reports" if name in known.own else "exists"


def _fix(name: str, names: Iterable[str], known: KnownErrors) -> str:
    return "Add it to the errors of a call." if name in known.own else did_you_mean(name, names)


def _is_undeclared(name: str, names: Collection[str], known: KnownErrors, function: FunctionJson) -> bool:
    """Errors of others are unknown, and no problem, where no catalogue says what there is."""
    return name not in names and (bool(known.names) or name.startswith(f"{function.info.function_name}_"))


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
