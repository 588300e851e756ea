"""The header: types, what the adapter holds, and what the platform calls."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.core.c import errors, inputs, methods
from sigcat.adapter.core.c.layout import c_lines
from sigcat.adapter.core.c.lines import Lines, code_of
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import CorePlan, ForeignError
from sigcat.function.document.text import Text, composed


class _Plan(NamedTuple):
    p: str
    m: str
    plan: CorePlan
    about: Text
    has_verdict: bool
    receive_heads: Sequence[str]
    reject_heads: Sequence[str]
    lose_heads: Sequence[str]
    offered_heads: Sequence[str]
    answer_heads: Sequence[str]


def header(scope: Scope) -> Lines:
    """The whole header. It has no verdict if nothing can be wrong."""
    plan = scope.plan
    made = _Plan(
        p=scope.prefix,
        m=scope.macro,
        plan=plan,
        about=about(plan),
        has_verdict=False,
        receive_heads=receive_heads(scope),
        reject_heads=[inputs.reject_head(each, scope) for each in plan.ports if each.tells_of_rejection],
        lose_heads=[inputs.lose_head(each, scope) for each in plan.ports if each.tells_of_loss],
        offered_heads=[methods.offered_head(each, scope) for each in plan.offered],
        answer_heads=[methods.answer_head(each, scope) for each in plan.requests],
    )
    whole = c_lines("header.h.j2", made)
    return (
        c_lines("header.h.j2", made._replace(has_verdict=True))
        if f"{scope.prefix}_Verdict" in code_of(whole)
        else whole
    )


def about(plan: CorePlan) -> Text:
    """The first sentence of both files."""
    version = f" {plan.version}" if plan.version else ""
    return composed(f"Adapter of {plan.function}{version}: ", plan.description)


def receive_heads(scope: Scope) -> list[str]:
    """Heads of all functions that receive values."""
    return [
        *(inputs.receive_head(port, scope) for port in scope.plan.ports),
        *(errors.reaction_head(reaction, scope) for reaction in scope.plan.reactions),
        *(status_head(each, scope) for each in scope.plan.received_statuses),
    ]


def status_head(status: ForeignError, scope: Scope) -> str:
    """The head of the function that takes a status."""
    return f"void {scope.prefix}_Receive_{status.name}({scope.self_argument}, {status.wire.c} value, uint64_t t)"
