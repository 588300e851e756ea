"""A node of an integration beside the core of its function: which interface is which place of the core."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from sigcat.adapter.host.host_plan import HostPlan
from sigcat.integration.ros2.model import Communication, Message, RosNode, RosService, RosTopic


@dataclass(frozen=True)
class NodeContext:
    """A node of an integration, and the host that it is for its function."""

    node: RosNode
    host: HostPlan
    communications: Sequence[Communication]
    messages: Mapping[str, Message]
    """Messages of the interface package, by name."""

    def topics(self, role: str) -> Iterator[tuple[str, RosTopic]]:
        """Topics of data that the node publishes or subscribes to, with the calls that do."""
        for communication in self.communications:
            for topic in communication.topics:
                if topic.node == self.node.name and topic.role == role:
                    yield communication.runnable, topic

    def services(self, role: str) -> Iterator[RosService]:
        """Services that the node offers or uses."""
        for communication in self.communications:
            for service in communication.services or ():
                if service.node == self.node.name and service.role == role:
                    yield service
