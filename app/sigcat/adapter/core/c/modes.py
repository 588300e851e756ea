"""Modes: which calls run (section 8)."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.core.c.layout import c_functions, text_of
from sigcat.adapter.core.c.lines import Line, Lines, block, choice, joined, lines
from sigcat.adapter.core.c.literals import time
from sigcat.adapter.core.c.scope import Scope
from sigcat.adapter.core.plan import Call, CorePlan, ModeIn, ModeOut, ModeValue
from sigcat.function.document.text_filters import block_comment


class _Plan(NamedTuple):
    """Plan of the functions; `dropped` are statements by the names of calls."""

    p: str
    m: str
    plan: CorePlan
    is_cpp: bool
    part: str
    mode: ModeIn | None
    moded: Sequence[Call]
    dropped: Mapping[str, str]
    mode_out: ModeOut | None
    sent_modes: Sequence[ModeValue]


def _functions(part: str, scope: Scope) -> list[Lines]:
    plan = scope.plan
    moded, out = [call for call in plan.steps if is_moded(call, scope)], plan.mode_out
    made = _Plan(
        p=scope.prefix,
        m=scope.macro,
        plan=plan,
        is_cpp=scope.is_cpp,
        part=part,
        mode=plan.mode_in,
        moded=moded,
        dropped={call.name: text_of(dropped(call, scope)) for call in moded},
        mode_out=out and out._replace(variable=scope.variable(out.variable)),
        sent_modes=_first_of_each_code(out) if out else (),
    )
    return c_functions("modes.c.j2", made)


def mode_functions(scope: Scope) -> list[Lines]:
    """Effect on calls when the mode is entered."""
    return _functions("in", scope) if scope.plan.mode_in else []


def runs_functions(scope: Scope) -> list[Lines]:
    """Modes that let each call run."""
    return _functions("runs", scope) if scope.plan.mode_in else []


def mode_out_functions(scope: Scope) -> list[Lines]:
    """The mode that the function is in: sent on change, if it has a name."""
    return _functions("out", scope) if scope.plan.mode_out else []


def is_moded(call: Call, scope: Scope) -> bool:
    """Whether a mode excludes the call."""
    mode = scope.plan.mode_in
    return mode is not None and any(each.name in (call.modes or ()) for each in mode.modes)


def condition(call: Call, scope: Scope) -> str:
    """The condition that a call may run."""
    return f"{scope.prefix}_Runs_{call.name}(self->mode.now)" if is_moded(call, scope) else "true"


def _constant(mode: ModeValue) -> str:
    return f"{mode.number}U {block_comment(mode.name)}"


def dropped(call: Call, scope: Scope) -> Lines:
    """Activations that are due are dropped and counted, and the values that would have been taken with them."""
    place = f"self->{call.name}"
    if call.cycle is not None:
        cycle = time(call.cycle)
        return block(f"if (t >= {place}.release)", [lines(f"""
            const uint64_t releases = ((t - {place}.release) / {cycle}) + 1U;

            {place}.release += releases * {cycle};
            {place}.dropped = {scope.prefix}_Added({place}.dropped, releases);
        """)])  # fmt: skip
    queues = [item for item in call.inputs if item.queue and item.port in call.triggers]
    return joined([
        lines(f"{place}.dropped = {scope.prefix}_Added({place}.dropped, {place}.events);\n{place}.events = 0U;"),
        *(lines(f"{place}.in.{item.named.name}.waiting = 0U;") for item in queues),
    ])  # fmt: skip


def written(scope: Scope) -> Lines:
    """The mode, written to its variable, as a number of the code."""
    mode = scope.plan.mode_in
    if mode is None or mode.variable is None:
        return ()
    variable = mode.variable
    if all(each.number == each.code for each in mode.modes):
        text = f"{scope.assigned(variable, 'self->mode.now')} {block_comment(mode.named.comment)}"
        return (Line(text, mode.named.pointer),)
    ways = [
        (f"self->mode.now == {_constant(each)}", lines(scope.assigned(variable, str(each.code)), mode.named.pointer))
        for each in mode.modes
    ]
    return choice([*ways[:-1], ("", ways[-1][1])])


def _first_of_each_code(mode: ModeOut) -> list[ModeValue]:
    return list({each.code: each for each in reversed(mode.modes)}.values())[::-1]
