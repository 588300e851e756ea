"""The source: every function in the order of a reader, and those that they need before them."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.core.c import (
    calls,
    errors,
    inputs,
    life,
    methods,
    modes,
    outputs,
    parameters,
    receiving,
    schedule,
    supervision,
)
from sigcat.adapter.core.c.header import about
from sigcat.adapter.core.c.layout import c_lines
from sigcat.adapter.core.c.lines import Lines, code_of, joined, spaced
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.c.sizes import Check, checks, used_macros
from sigcat.adapter.core.c.small_functions import used_functions
from sigcat.adapter.core.plan import Call, CodeObject, CorePlan, Extern
from sigcat.function.document.text import Text


class _Plan(NamedTuple):
    """Plan of what stands before the functions."""

    p: str
    m: str
    plan: CorePlan
    about: Text
    is_cpp: bool
    uses_math: bool
    uses_memory: bool
    objects: Sequence[CodeObject]
    externs: Sequence[Extern]
    prototypes: Sequence[Call]
    checks: Sequence[Check]
    macros: frozenset[str]


def source(scope: Scope) -> Lines:
    """The whole source."""
    body = _without_unused_tables(_functions(scope))
    text = code_of(joined(body))
    plan, found = scope.plan, checks(scope)
    before = _Plan(
        p=scope.prefix,
        m=scope.macro,
        plan=plan,
        about=about(plan),
        is_cpp=scope.is_cpp,
        uses_math="_Quiet" in text or "_ToFloat(" in text,
        uses_memory="mem" in text,
        objects=[each._replace(name=scope.variable(each.name)) for each in plan.code.objects],
        externs=[each._replace(name=scope.variable(each.name)) for each in plan.code.externs],
        prototypes=() if plan.code.headers else plan.calls,
        checks=found,
        macros=used_macros(found, scope),
    )
    return spaced([c_lines("source.c.j2", before), *used_functions(text, scope.prefix, scope.macro), *body])


def _without_unused_tables(parts: list[Lines]) -> list[Lines]:
    """Tables of constants stand before what may use them; where a constant cannot come up, nothing does."""
    text = code_of(joined(parts))
    return [part for part in parts if not part[0].text.startswith("static const ") or text.count(_name(part)) > 1]


def _name(table: Lines) -> str:
    return table[0].text.partition("[")[0].rpartition(" ")[2]


def _functions(scope: Scope) -> list[Lines]:
    steps = scope.plan.steps
    return [part for part in (
        *receiving.receive_functions(scope),
        *(part for call in steps for part in inputs.take_functions(call, scope)),
        *(part for call in steps for part in outputs.give_functions(call, scope)),
        *parameters.parameter_functions(scope),
        parameters.set_function(scope),
        *modes.runs_functions(scope),
        *supervision.supervision_functions(scope),
        *errors.error_functions(scope),
        *modes.mode_out_functions(scope),
        *schedule.enter_functions(scope),
        *modes.mode_functions(scope),
        *schedule.due_functions(scope),
        *methods.method_functions(scope),
        *calls.call_functions(scope),
        *life.life_functions(scope),
    ) if part]  # fmt: skip
