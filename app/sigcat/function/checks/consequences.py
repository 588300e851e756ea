"""Problems that only follow from others: fixed with these, and so not reported beside them."""

from collections.abc import Callable, Collection, Iterable

from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.names import last_name, nearest

_MISTYPED = frozenset(("scheduling", "error"))
"""Kinds of subjects that a declaration names itself: what is missing may be there under a near name."""


def without_consequences(
    problems: Iterable[Problem],
    missing: Collection[Subject],
    is_reported: Callable[[Subject], bool],
    path_of: Callable[[str], str],
) -> Problems:
    """The problems that do not follow from others.

    `missing` are the parts that could not be resolved. `is_reported` says whether the rules of the catalogue have found
    fault with a subject; `path_of` is the path of an interface name, or the name itself.
    """
    circles: dict[int, bool] = {}  # by identity: a circle of thousands is the same tuple in each of its problems
    for problem in problems:
        if problem.circle and id(problem.circle) not in circles:
            circles[id(problem.circle)] = any(map(is_reported, problem.circle))
        is_consequence = problem.cause is not None and _is_missing(problem.cause, missing, path_of)
        if problem.circle:
            is_repeated = circles[id(problem.circle)]
        else:
            is_repeated = problem.subject is not None and is_reported(problem.subject)
        if not is_consequence and not is_repeated:
            yield problem


def _is_missing(cause: Subject, missing: Collection[Subject], path_of: Callable[[str], str]) -> bool:
    """Whether a cause is missing, under its own name or one that was mistyped."""
    if cause in missing or cause.kind not in _MISTYPED:
        return cause in missing
    names = {subject.name for subject in missing if subject.kind == cause.kind}
    return bool(names) and any(nearest(name, names) for name in (cause.name, last_name(path_of(cause.name))))
