"""The variables of the code that a core reads and writes: the fields of its plan that are called `variable`, or end so."""

from collections.abc import Callable
from typing import TypeVar

from sigcat.adapter.core.plan import CorePlan

_T = TypeVar("_T")
_Rewrite = Callable[[str], str]


def expressions(plan: CorePlan) -> tuple[str, ...]:
    """Each expression of a variable of the code."""
    found: list[str] = []

    def collect(expression: str) -> str:
        found.append(expression)
        return expression

    with_variables(plan, collect)
    return tuple(found)


def with_variables(plan: CorePlan, rewrite: _Rewrite) -> CorePlan:
    """The same plan, with each expression of a variable rewritten."""
    code = plan.code
    if plan.has_globals:  # otherwise they are members
        code = code._replace(
            objects=tuple(each._replace(name=rewrite(each.name)) for each in code.objects),
            externs=tuple(each._replace(name=rewrite(each.name)) for each in code.externs),
        )
    return _rewritten(plan._replace(code=code), rewrite)


def _rewritten(part: _T, rewrite: _Rewrite) -> _T:
    """A part of the plan; one without variables is the same object."""
    if not isinstance(part, tuple):
        return part
    names = getattr(part, "_fields", ("",) * len(part))
    items = [
        rewrite(item) if name.endswith("variable") and item is not None else _rewritten(item, rewrite)
        for name, item in zip(names, part, strict=True)
    ]
    if all(new is old for new, old in zip(items, part, strict=True)):
        return part
    return type(part)(*items) if hasattr(part, "_fields") else type(part)(items)
