"""A node of an integration beside the core of its function: which interface is which place of the core."""

from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property

from sigcat.adapter.core.places import CorePlaces
from sigcat.adapter.core.plan import CorePlan, Port
from sigcat.function.function_json.model import FunctionJson
from sigcat.integration.ros2.model import Communication, FieldMapping, Message, RosNode, RosService, RosTopic
from sigcat.integration.ros2.topics import SUBSCRIPTION


class NodeContext(CorePlaces):
    """A node of an integration, beside the core of its function."""

    def __init__(
        self,
        node: RosNode,
        function: FunctionJson,
        core: CorePlan,
        communications: Sequence[Communication],
        messages: Mapping[str, Message],
    ) -> None:
        super().__init__(function, core)
        self.node = node
        self.communications = communications
        self.messages = messages
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

    @cached_property
    def receiving_ports(self) -> Mapping[str, tuple[Port, ...]]:
        """Places that take each signal: another call of the function may send it."""
        found: dict[str, dict[str, Port]] = {}
        for call, topic in self.topics(SUBSCRIPTION):
            for mapping in topic.mappings:
                if (port := self.port(call, mapping.signal)) is not None:
                    found.setdefault(signal_key(mapping), {})[port.name] = port
        return {key: tuple(ports.values()) for key, ports in found.items()}


def signal_key(mapping: FieldMapping) -> str:
    """The signal of a field, which calls of a function have in common: its path, or its name if it has none."""
    return mapping.vss_path or mapping.signal
