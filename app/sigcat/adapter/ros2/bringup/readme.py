"""The page for who builds and runs the packages."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.ros2.bringup.graph import publishers_of, subscribers_of
from sigcat.adapter.ros2.bringup.picture import OUTSIDE, Picture, picture
from sigcat.adapter.ros2.plan import (
    Given,
    Monitor,
    NodeParameter,
    NodePlan,
    Publisher,
    Subscription,
    Taken,
    WorkspacePlan,
)
from sigcat.adapter.templates import rendered
from sigcat.function.document.text_filters import AnyText
from sigcat.integration.ros2.model import QualityOfService, Ros2Integration
from sigcat.integration.ros2.topics import PUBLISHER

_NANOSECONDS_IN_MILLISECOND = 10**6


class _Node(NamedTuple):
    name: str
    executable: str
    component: str
    function: str
    calls: Sequence[tuple[str, str]]
    """Names of calls, and when they run."""
    setting: str


class _Topic(NamedTuple):
    name: str
    type: str
    sources: Sequence[str]
    provider: AnyText
    """The source outside, if there is none in the set."""
    targets: Sequence[str]
    quality: str
    fields: Sequence[tuple[str, AnyText]]


class _Service(NamedTuple):
    name: str
    type: str
    way: str
    node: str


class _Readme(NamedTuple):
    workspace: WorkspacePlan
    nodes: Sequence[_Node]
    picture: Picture
    topics: Iterable[_Topic]
    services: Sequence[_Service]
    errors: Sequence[tuple[str, Monitor]]
    """Each with the name of its node."""
    parameters: Sequence[tuple[str, NodeParameter]]
    """Each with the name of its node."""


def readme(workspace: WorkspacePlan, model: Ros2Integration) -> str:
    """README.md."""
    providers, nodes = providers_of(model), workspace.nodes
    plan = _Readme(
        workspace,
        nodes=[*map(_node, nodes)],
        picture=picture(workspace, providers),
        topics=_topics(workspace, providers),
        services=[*_services(nodes)],
        errors=[(node.name, monitor) for node in nodes for monitor in node.monitors],
        parameters=[(node.name, parameter) for node in nodes for parameter in node.parameters],
    )
    return rendered("adapter/ros2/bringup/README.md.j2", plan)


def providers_of(model: Ros2Integration) -> Mapping[str, AnyText]:
    """Publishers of a topic outside of the set, as functions and the deployment name them."""
    found: dict[str, AnyText] = {}
    for topic in (topic for communication in model.communications for topic in communication.topics):
        for mapping in (mapping for data_map in topic.data_maps for mapping in data_map.mappings or ()):
            if topic.role != PUBLISHER and mapping.external_provider:
                found.setdefault(topic.name, mapping.external_provider)
    for node in (node for package in model.node_packages or () for node in package.nodes):
        for end in (*node.modes, *node.error_topics, *node.reaction_topics):
            if end.role != PUBLISHER and end.provider:
                found.setdefault(end.topic, end.provider)
    return found


def _node(node: NodePlan) -> _Node:
    calls = [
        (step.interface, f"{step.cycle / _NANOSECONDS_IN_MILLISECOND:g} ms" if step.cycle else "on events")
        for step in node.steps
    ]
    component = f"{node.package}::{node.type}"
    return _Node(node.name, node.executable, component, node.core.function, calls, node.core.code_setting)


def _topics(workspace: WorkspacePlan, providers: Mapping[str, AnyText]) -> Iterable[_Topic]:
    published, heard = publishers_of(workspace), subscribers_of(workspace)
    found = {}
    for end in _ends(workspace):
        name, message = end.topic, end.message
        found[name] = _Topic(
            name=name,
            type=f"{message.package}/{message.kind}/{message.name}",
            sources=published.get(name, ()),
            provider=providers.get(name, OUTSIDE),
            targets=heard.get(name, ()),
            quality=_quality(end.quality),
            fields=_fields(end),
        )
    return found.values()


def _ends(workspace: WorkspacePlan) -> Iterator[Publisher | Subscription]:
    """Every end of a topic, publishers last: of a topic that has both, the offer and all fields are shown."""
    for node in workspace.nodes:
        yield from node.subscriptions
    for node in workspace.nodes:
        yield from node.publishers


def _fields(end: Publisher | Subscription) -> Sequence[tuple[str, AnyText]]:
    listed: Sequence[Taken | Given] = end.gives if isinstance(end, Publisher) else end.takes
    return [(each.field, each.comment) for each in listed]


def _quality(quality: QualityOfService) -> str:
    said = [quality.reliability.replace("_", " "), quality.durability.replace("_", " "), f"depth {quality.depth}"]
    if quality.deadline is not None:
        said.append(f"deadline {quality.deadline:g} ms")
    if quality.lease_duration is not None:
        said.append(f"liveliness {quality.liveliness.replace('_', ' ')} {quality.lease_duration:g} ms")
    return ", ".join(said)


def _services(nodes: Iterable[NodePlan]) -> Iterator[_Service]:
    for node in nodes:
        for way, listed in (("offered", node.offered), ("used", node.used)):
            for each in listed:
                yield _Service(each.topic, f"{each.service.package}/srv/{each.service.name}", way, node.name)
