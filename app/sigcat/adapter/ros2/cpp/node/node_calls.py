"""The calls of a node, which a loop runs when they are due; in lock-step, when the node receives the time."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.core.plan import Call
from sigcat.adapter.ros2.cpp.names import scope_of
from sigcat.adapter.ros2.plan import NodePlan
from sigcat.names import snake_case


class NodeCall(NamedTuple):
    """A call, its constant in the core, and the stem of names that the node has for it."""

    step: Call
    constant: str
    stem: str


def node_calls(node: NodePlan) -> Sequence[NodeCall]:
    """All of them."""
    constant = scope_of(node).call
    return [NodeCall(step, constant(step.name), _stem(node, step)) for step in node.core.steps]


def _stem(node: NodePlan, call: Call) -> str:
    """A call in snake_case, unless another one has the same."""
    names = [snake_case(step.name) for step in node.core.steps]
    name = snake_case(call.name)
    return name if name and names.count(name) == 1 else call.name
