"""Connections in a set, and the order in which its nodes are activated."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.ros2.plan import NodePlan, WorkspacePlan


class Edge(NamedTuple):
    """Topics that lead from one node to another."""

    source: str
    target: str
    topics: tuple[str, ...]


def publishers_of(workspace: WorkspacePlan) -> Mapping[str, tuple[str, ...]]:
    """Nodes that publish each topic."""
    found: dict[str, tuple[str, ...]] = {}
    for node in workspace.nodes:
        for end in node.publishers:
            found[end.topic] = (*found.get(end.topic, ()), node.name)
    return found


def subscribers_of(workspace: WorkspacePlan) -> Mapping[str, tuple[str, ...]]:
    """Nodes that take each topic."""
    found: dict[str, tuple[str, ...]] = {}
    for node in workspace.nodes:
        for end in node.subscriptions:
            found[end.topic] = (*found.get(end.topic, ()), node.name)
    return found


def edges_of(workspace: WorkspacePlan) -> tuple[Edge, ...]:
    """Topics and services between nodes of the set."""
    publishers = publishers_of(workspace)
    found: dict[tuple[str, str], list[str]] = {}
    for node in workspace.nodes:
        for end in node.subscriptions:
            for source in publishers.get(end.topic, ()):
                found.setdefault((source, node.name), []).append(end.topic)
    return tuple(Edge(source, target, tuple(topics)) for (source, target), topics in found.items())


def in_order_of_activation(workspace: WorkspacePlan) -> tuple[NodePlan, ...]:
    """Each node after those that it hears; where they hear each other, in the order of the set."""
    heard: dict[str, set[str]] = {node.name: set() for node in workspace.nodes}
    for edge in edges_of(workspace):
        heard[edge.target].add(edge.source)
    waiting = list(workspace.nodes)
    ordered: list[NodePlan] = []
    while waiting:
        first = _first(waiting, heard)
        waiting.remove(first)
        ordered.append(first)
    return tuple(ordered)


def _first(waiting: Sequence[NodePlan], heard: Mapping[str, set[str]]) -> NodePlan:
    names = {node.name for node in waiting}
    return next((node for node in waiting if not (heard[node.name] - {node.name}) & names), waiting[0])
