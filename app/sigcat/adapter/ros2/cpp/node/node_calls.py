"""The calls of a node, which a loop runs when they are due; in lock-step, when the node receives the time."""

from collections import Counter
from collections.abc import Mapping

from sigcat.adapter.ros2.plan import NodePlan
from sigcat.names import snake_case


def stems_of(node: NodePlan) -> Mapping[str, str]:
    """Stems of names that the node has for a call: its name in snake_case, unless another one has the same."""
    stems = {step.name: snake_case(step.name) for step in node.core.steps}
    uses = Counter(stems.values())
    return {name: stem if stem and uses[stem] == 1 else name for name, stem in stems.items()}
