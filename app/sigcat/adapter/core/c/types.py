"""Types of the header, for those that need them without it."""

from collections.abc import Iterable
from typing import NamedTuple

from sigcat.adapter.core.c.layout import c_lines
from sigcat.adapter.core.c.lines import Line, Lines, indented, joined
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import CorePlan
from sigcat.function.document.text_filters import AnyText, block_comment


class _Plan(NamedTuple):
    p: str
    m: str
    plan: CorePlan
    has_verdict: bool


def struct(name: str, members: Iterable[Lines], comment: AnyText = "") -> Lines:
    """A struct type."""
    before = (Line(block_comment(comment)),) if comment else ()
    return (*before, Line("typedef struct {"), *indented(joined(members)), Line(f"}} {name};"))


def types(scope: Scope) -> list[Lines]:
    """Each enumeration and struct type."""
    found: list[list[Line]] = [[]]
    for line in c_lines("types.h.j2", _Plan(scope.prefix, scope.macro, scope.plan, has_verdict=True)):
        if line.text:
            found[-1].append(line)
        else:
            found.append([])
    return [tuple(part) for part in found]
