"""The page for who builds and runs the packages."""

from collections.abc import Iterator, Mapping

from sigcat.adapter.ros2.bringup.graph import publishers_of, subscribers_of
from sigcat.adapter.ros2.bringup.picture import OUTSIDE, picture
from sigcat.adapter.ros2.plan import Publisher, Subscription, WorkspacePlan
from sigcat.adapter.templates import rendered
from sigcat.function.document.text_filters import AnyText
from sigcat.integration.ros2.model import Ros2Integration
from sigcat.integration.ros2.topics import PUBLISHER


def readme(workspace: WorkspacePlan, model: Ros2Integration) -> str:
    """README.md."""
    providers = providers_of(model)
    return rendered(
        "adapter/ros2/bringup/README.md.j2",
        workspace=workspace,
        picture=picture(workspace, providers),
        topics={end.topic: end for end in _ends(workspace)},
        publishers=publishers_of(workspace),
        subscribers=subscribers_of(workspace),
        provider_of=lambda topic: providers.get(topic, OUTSIDE),  # if no node of the set publishes it
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


def _ends(workspace: WorkspacePlan) -> Iterator[Publisher | Subscription]:
    """Every end of a topic, publishers last: of a topic that has both, the offer and all fields are shown."""
    for node in workspace.nodes:
        yield from node.subscriptions
    for node in workspace.nodes:
        yield from node.publishers
