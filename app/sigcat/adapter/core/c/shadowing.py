"""Variables of the code with names that functions of the adapter use for their own variables: these are renamed."""

import re
from collections.abc import Iterable, Iterator

from sigcat.adapter.core.c.lines import Lines, code_of, replaced
from sigcat.adapter.core.c.scope import MARK
from sigcat.adapter.core.plan import GLOBALS, Call, CorePlan

_LOCAL = re.compile(r"\s+(?:static )?(?:const )?[A-Za-z_]\w* \*?([A-Za-z_]\w*)(?:\[[^]]*\])?(?: = .*)?;")
_HEAD = re.compile(r"^(?:static )?[A-Za-z_][\w ]* \*?\w+\(([^(){};]*)\)$", re.MULTILINE)
"""It may have several lines."""
_ARGUMENT = re.compile(r"(\w+)(?:,|$)")
_NAME = re.compile(r"(?<![\w.>])[A-Za-z_]\w*")


def shadowed(plan: CorePlan, part: Lines) -> frozenset[str]:
    """Names of the code that mean something else within a function."""
    if plan.code.signature != GLOBALS:
        return frozenset()
    own = {name for text in _expressions(plan) for name in _NAME.findall(text)}
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


def _expressions(plan: CorePlan) -> Iterator[str]:
    """Every expression of the code."""
    found = [each for call in plan.calls for each in _of_call(call)]
    found += [each.variable for each in plan.parameters]
    for error in plan.errors:
        found += [error.variable, error.status_variable]
    found += [each.variable for each in (*plan.reactions, plan.mode_in, plan.mode_out) if each]
    for method in plan.methods:
        arguments = (*method.arguments, *method.results)
        found += [method.request_variable, method.status_variable, *(each.variable for each in arguments)]
    return (text for text in found if text is not None)


def _of_call(call: Call) -> Iterator[str | None]:
    yield from (each.variable for each in call.inputs)
    yield from (each.variable for each in call.outputs)
    queues = [*(each.queue for each in call.inputs), *(each.queue for each in call.outputs)]
    yield from (queue.count_variable for queue in queues if queue)
