"""Connections in a set, and the order in which its nodes are activated."""

from collections.abc import Iterable, Mapping

from sigcat.adapter.ros2.plan import NodePlan, WorkspacePlan


def publishers_of(workspace: WorkspacePlan) -> Mapping[str, tuple[str, ...]]:
    """Nodes that publish each topic."""
    return _nodes_by_topic((end.topic, node) for node in workspace.nodes for end in node.publishers)


def subscribers_of(workspace: WorkspacePlan) -> Mapping[str, tuple[str, ...]]:
    """Nodes that take each topic."""
    return _nodes_by_topic((end.topic, node) for node in workspace.nodes for end in node.subscriptions)


def _nodes_by_topic(ends: Iterable[tuple[str, NodePlan]]) -> Mapping[str, tuple[str, ...]]:
    found: dict[str, tuple[str, ...]] = {}
    for topic, node in ends:
        found[topic] = (*found.get(topic, ()), node.name)
    return found


def in_order_of_activation(workspace: WorkspacePlan) -> tuple[NodePlan, ...]:
    """Each node after those that it hears; where they hear each other, in the order of the set."""
    publishers = publishers_of(workspace)
    heard = {
        node.name: {source for end in node.subscriptions for source in publishers.get(end.topic, ())} - {node.name}
        for node in workspace.nodes
    }
    waiting = list(workspace.nodes)
    ordered: list[NodePlan] = []
    while waiting:
        names = {node.name for node in waiting}
        ordered.append(next((node for node in waiting if not heard[node.name] & names), waiting[0]))
        waiting.remove(ordered[-1])
    return tuple(ordered)
