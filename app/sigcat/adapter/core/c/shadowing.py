"""Variables of the code with names that functions of the adapter use for their own variables: these are renamed."""

import re
from collections.abc import Iterable, Iterator

from sigcat.adapter.core.c.lines import Lines, code_of, replaced
from sigcat.adapter.core.c.scope import MARK
from sigcat.adapter.core.plan import GLOBALS, CorePlan
from sigcat.adapter.core.variables import expressions

_LOCAL = re.compile(r"\s+(?:static )?(?:const )?[A-Za-z_]\w* \*?([A-Za-z_]\w*)(?:\[[^]]*\])?(?: = .*)?;")
_HEAD = re.compile(r"^(?:static )?[A-Za-z_][\w ]* \*?\w+\(([^(){};]*)\)$", re.MULTILINE)
"""It may have several lines."""
_ARGUMENT = re.compile(r"(\w+)(?:,|$)")
_NAME = re.compile(r"(?<![\w.>])[A-Za-z_]\w*")


def shadowed(plan: CorePlan, part: Lines) -> frozenset[str]:
    """Names of the code that mean something else within a function."""
    if plan.code.signature != GLOBALS:
        return frozenset()
    own = {name for text in expressions(plan) for name in _NAME.findall(text)}
    return frozenset(own.intersection(_locals(part)))


def renamed(part: Lines, names: Iterable[str]) -> Lines:
    """Lines in which these names are the code's where they are marked, and others where they are not."""
    found = replaced(rf"(?<![\w.>{MARK}])(?P<name>{'|'.join(sorted(names))})\b", r"\g<name>_", part)
    return tuple(line._replace(text=line.text.replace(MARK, "")) for line in found)


def _locals(part: Lines) -> Iterator[str]:
    for head in _HEAD.finditer(code_of(part)):
        yield from _ARGUMENT.findall(head[1])
    for row in code_of(part).split("\n"):
        if local := _LOCAL.fullmatch(row.rstrip()):
            yield local[1]
