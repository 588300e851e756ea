"""The calls of a node, which a loop runs when they are due; in lock-step, when the node receives the time."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.core.plan import Call
from sigcat.adapter.ros2.cpp.layout import call
from sigcat.adapter.ros2.cpp.names import report_name, run_name, scope_of, times_name
from sigcat.adapter.ros2.plan import NodePlan
from sigcat.function.document.text import composed
from sigcat.function.document.text_filters import AnyText, c_string


class NodeCall(NamedTuple):
    """A call: its name in the core, its constant there, its function and the member that has its times."""

    name: str
    constant: str
    run: str
    times: str
    about: AnyText
    longest: int | None
    """Nanoseconds that it may run; None without a deadline."""
    report: str
    """The variable of its diagnostics."""
    reported: str
    """The statement that fills it, under the lock of the core."""
    status: str
    """The statement that tells it."""


def node_calls(node: NodePlan) -> Sequence[NodeCall]:
    """All of them."""
    return [_call(step, node) for step in node.steps]


def _call(step: Call, node: NodePlan) -> NodeCall:
    report, times, place = report_name(node, step), times_name(node, step), f"core_->adapter.{step.name}"
    missed = f"{place}.missed" if step.cycle is not None else "0"
    status = call("call_status", ["node", c_string(step.interface), report], ")", 3)
    return NodeCall(
        step.name,
        scope_of(node).call(step.name),
        run_name(node, step),
        times,
        composed(step.interface, ": ", step.description) if step.description else step.interface,
        None if step.deadline is None else step.deadline.most,
        report,
        call(f"{report} = {times}.report", [missed, f"{place}.dropped"], levels=2),
        call("told.status.push_back", [status]),
    )
