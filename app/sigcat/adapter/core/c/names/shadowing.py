"""Variables of the code with names that functions of the adapter use for their own variables: these are renamed."""

import re
from collections.abc import Iterator

from sigcat.adapter.core.c.names.scope import MARK, NAME
from sigcat.adapter.core.c.text.lines import Lines, code_of, replaced
from sigcat.adapter.core.plan import GLOBALS, CorePlan
from sigcat.adapter.core.variables import expressions

_LOCAL = re.compile(r"\s+(?:static )?(?:const )?[A-Za-z_]\w* \*?([A-Za-z_]\w*)(?:\[[^]]*\])?(?: = .*)?;")
_HEAD = re.compile(r"^(?:static )?[A-Za-z_][\w ]* \*?\w+\(([^(){};]*)\)$", re.MULTILINE)
"""It may have several lines."""
_ARGUMENT = re.compile(r"(\w+)(?:,|$)")


def distinct(plan: CorePlan, part: Lines) -> Lines:
    """Lines without marks, whose own variables have other names than those of the code."""
    own = {name for text in expressions(plan) for name in NAME.findall(text)}
    names = own.intersection(_locals(part)) if plan.code.signature == GLOBALS else ()
    if names:
        part = replaced(rf"(?<![\w.>{MARK}])(?P<name>{'|'.join(sorted(names))})\b", r"\g<name>_", part)
    return tuple(line._replace(text=line.text.replace(MARK, "")) for line in part)


def _locals(part: Lines) -> Iterator[str]:
    for head in _HEAD.finditer(code_of(part)):
        yield from _ARGUMENT.findall(head[1])
    for row in code_of(part).split("\n"):
        if local := _LOCAL.fullmatch(row.rstrip()):
            yield local[1]
