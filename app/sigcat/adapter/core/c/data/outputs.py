"""Outputs: from the variables of the code to what is sent (sections 4 and 5)."""

from typing import NamedTuple

from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.c.values.c_values import Transfer, from_variable, transfer
from sigcat.adapter.core.plan import Call, Output


class OutputPlan(NamedTuple):
    """An output of a call."""

    output: Output
    name: str
    """Ending of the name of its function: `Step_AccReq`."""
    place: str
    """Member with its verdicts: `self->Step.out.AccReq`."""
    given: Transfer
    """From the variable to what is sent."""
    keeps: bool
    """Whether the value before stays if an enumeration has no name for this one."""


def output_plan(call: Call, output: Output, scope: Scope) -> OutputPlan:
    """An output, as functions of the adapter give it."""
    name, sent, value = f"{call.name}_{output.named.name}", f"self->out.{output.named.name}", output.value
    queue = output.queue
    variable = f"{output.variable}[given]" if queue and queue.count_variable else output.variable
    ends = from_variable(variable, f"{sent}.values[given]" if queue else sent, name, output.named.pointer, scope)
    kinds = {"init" if queue is None else "", "replacement" if value.is_checked and value.is_replaced else ""}
    keeps = any(leaf.element.names is not None for leaf in value.leaves) and not value.is_replaced
    return OutputPlan(output, name, f"self->{call.name}.out.{output.named.name}", transfer(value, ends, kinds), keeps)
