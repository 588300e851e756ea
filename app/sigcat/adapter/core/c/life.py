"""The beginning of a function: what its adapter clears, writes and sets (section 1)."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.core.c.calls.call_functions import CallPlan
from sigcat.adapter.core.c.data.inputs import InputPlan
from sigcat.adapter.core.c.data.outputs import OutputPlan
from sigcat.adapter.core.plan import CorePlan


class InitialValues(NamedTuple):
    """Values before anything is received."""

    inputs: Sequence[InputPlan]
    outputs: Sequence[OutputPlan]
    is_written: bool
    """Whether any variable of the code is written."""
    uses_self: bool
    """Whether that uses the adapter."""
    is_set: bool
    """Whether any member of the adapter is set."""


def initial_values(plan: CorePlan, calls: Sequence[CallPlan], received: Sequence[str | None]) -> InitialValues:
    """Values of all calls; `received` are numbers of ports that are there from the start."""
    inputs = [each for call in calls for each in call.inputs]
    outputs = [each for call in calls for each in call.outputs if each.output.queue is None]
    counts = [each.item.queue.count_variable for each in inputs if each.item.queue]
    variables = [*(each.item.variable for each in inputs), *counts, *(each.request_variable for each in plan.requests)]
    mode = plan.mode_in
    states = [
        *(each.status_variable for each in plan.errors),
        *(each.status_variable for each in plan.requests),
        *(each.variable for each in plan.reactions),
        mode.variable if mode and len(mode.cases) != 1 else None,
    ]
    return InitialValues(
        inputs=inputs,
        outputs=outputs,
        is_written=bool(inputs or plan.requests or any(states) or (mode and mode.variable)),
        uses_self=any(states) or any("self->" in each for each in variables if each),
        is_set=bool(outputs or plan.errors or plan.reactions or any(received) or mode or plan.parameters),
    )


def cleared_members(plan: CorePlan) -> list[str]:
    """Members of the adapter that start with zeros."""
    groups = {
        "mode": plan.mode_in,
        "mode_out": plan.mode_out,
        "checkpoint": plan.has_checkpoints,
        "error": plan.errors,
        "reaction": plan.reactions,
        "method": plan.requests,
        "parameter": plan.parameters,
        "out": plan.is_sent,
        "publish": plan.published,
        "code": plan.code.objects and not plan.has_globals,
    }
    received = ["received"] if plan.is_received else []
    return [*received, *(call.name for call in plan.steps), *(name for name, has_any in groups.items() if has_any)]
