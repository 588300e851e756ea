"""The page for who builds and runs the packages."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.ros2.bringup.graph import publishers_of, subscribers_of
from sigcat.adapter.ros2.bringup.picture import OUTSIDE, picture
from sigcat.adapter.ros2.plan import (
    Publisher,
    ReceivedField,
    SentField,
    Subscription,
    WorkspacePlan,
)
from sigcat.adapter.templates import rendered
from sigcat.function.document.text_filters import AnyText
from sigcat.integration.ros2.model import QualityOfService, Ros2Integration
from sigcat.integration.ros2.topics import PUBLISHER


class _Topic(NamedTuple):
    name: str
    type: str
    sources: Sequence[str]
    provider: AnyText
    """The source outside, if there is none in the set."""
    targets: Sequence[str]
    quality: QualityOfService
    fields: Sequence[ReceivedField | SentField]


def readme(workspace: WorkspacePlan, model: Ros2Integration) -> str:
    """README.md."""
    providers = providers_of(model)
    return rendered(
        "adapter/ros2/bringup/README.md.j2",
        workspace=workspace,
        picture=picture(workspace, providers),
        topics=_topics(workspace, providers),
    )


def providers_of(model: Ros2Integration) -> Mapping[str, AnyText]:
    """Publishers of a topic outside of the set, as functions and the deployment name them."""
    found: dict[str, AnyText] = {}
    for topic in (topic for communication in model.communications for topic in communication.topics):
        for mapping in topic.mappings:
            if topic.role != PUBLISHER and mapping.external_provider:
                found.setdefault(topic.name, mapping.external_provider)
    for node in (node for package in model.node_packages or () for node in package.nodes):
        for end in (*node.modes, *node.error_topics, *node.reaction_topics):
            if end.role != PUBLISHER and end.provider:
                found.setdefault(end.topic, end.provider)
    return found


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
            quality=end.quality,
            fields=end.gives if isinstance(end, Publisher) else end.takes,
        )
    return found.values()


def _ends(workspace: WorkspacePlan) -> Iterator[Publisher | Subscription]:
    """Every end of a topic, publishers last: of a topic that has both, the offer and all fields are shown."""
    for node in workspace.nodes:
        yield from node.subscriptions
    for node in workspace.nodes:
        yield from node.publishers
