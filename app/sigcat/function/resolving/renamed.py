"""A function whose interfaces bear another name: one mistake, not one at each of them."""

from collections.abc import Sequence

from sigcat import codes
from sigcat.catalogue.model.interfaces import function_of
from sigcat.function.declaration.declaration import Declaration
from sigcat.function.document.field_types import VSS_PATH
from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.function.resolving.context import Context

_RULES = frozenset(
    (codes.INTERFACE_UNKNOWN.id, codes.INTERFACE_OF_ANOTHER_FUNCTION.id, codes.SIGNAL_UNKNOWN.id)
)  # fmt: skip
"""Rules of findings about an interface that has the name of another function."""


def told_once(problems: Sequence[Problem], declaration: Declaration, context: Context) -> Problems:
    """The problems; where every call is one of another function, a single one instead of those that follow from it."""
    other = _other_name(declaration, context)
    if other:
        message = f"The function must be named {other!r}, as its calls are, not {context.function!r}."
        fix = "Change the name."
        if VSS_PATH.accepts(context.function):
            fix = f"Change the name, or begin those of its interfaces with '{context.function}_'."
        subject = Subject("function", context.function)
        yield Problem(codes.INTERFACE_OF_ANOTHER_FUNCTION, ("function",), message, fix, subject)
    for problem in problems:
        if not (other and _bears(problem, other)):
            yield problem


def _other_name(declaration: Declaration, context: Context) -> str:
    """The function of every call that the file lists, if it is another one; otherwise nothing."""
    references = [call.interface for component in declaration.components for call in component.runnables]
    owners = {_owner(reference, context) for reference in references}
    return owners.pop() if len(owners) == 1 and context.function not in owners else ""


def _owner(reference: str, context: Context) -> str:
    """The function that a call exists for, under its own name or under this one's; nothing if there is no such call."""
    node = context.node(reference, "scheduling")
    if node is not None:
        return function_of(node.path)
    owner, _, last = reference.rpartition("_")
    return owner if f"{context.function}_{last}" in context.interfaces else ""


def _bears(problem: Problem, name: str) -> bool:
    """Whether a problem is about an interface of the function of a name."""
    is_its = problem.path.startswith(f"{name}_") or function_of(problem.path) == name
    return problem.rule.id in _RULES and is_its
