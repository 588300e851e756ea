"""The calls of a node, which a loop runs when they are due; in lock-step, when the node receives the time."""

from collections.abc import Mapping

from sigcat.adapter.ros2.plan import NodePlan
from sigcat.names import snake_case


def stems_of(node: NodePlan) -> Mapping[str, str]:
    """Stems of names that the node has for a call: its name in snake_case, unless another one has the same."""
    names = [snake_case(step.name) for step in node.core.steps]
    is_used = {name: bool(name) and names.count(name) == 1 for name in names}
    steps = zip(node.core.steps, names, strict=True)
    return {step.name: name if is_used[name] else step.name for step, name in steps}
