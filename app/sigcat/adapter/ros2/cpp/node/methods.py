"""Methods that the function uses or offers, as services."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.ros2.cpp.names import is_plain, short
from sigcat.adapter.ros2.plan import ArgumentField, MethodService, NodePlan, WorkspacePlan


class Copied(NamedTuple):
    """A field of a request or response, and the argument or result of the core that is copied from or to it."""

    field: str
    argument: str
    is_plain: bool


class Service(NamedTuple):
    """A method of the function, which answers requests of others, or of another function, which this one requests."""

    member: str
    topic: str
    type: str
    method: str
    request: Sequence[Copied]
    response: Sequence[Copied]
    success: str | None


class Methods(NamedTuple):
    """All methods of a node."""

    quality: str
    """Quality of service of services, as the release takes it."""
    offered: Sequence[Service]
    used: Sequence[Service]


def methods_of(node: NodePlan, workspace: WorkspacePlan) -> Methods:
    """All that it offers and uses."""
    return Methods(
        "rmw_qos_profile_services_default" if workspace.release == "humble" else "rclcpp::ServicesQoS()",
        [_service(each, node.private(each.topic), node) for each in node.offered],
        [_service(each, each.topic, node) for each in node.used],
    )


def _service(each: MethodService, topic: str, node: NodePlan) -> Service:
    return Service(
        each.member,
        topic,
        short(each.service, node),
        each.method.named.name,
        _copied(each.request),
        _copied(each.response),
        each.success,
    )


def _copied(fields: Sequence[ArgumentField]) -> Sequence[Copied]:
    return [Copied(each.field, each.argument.name, is_plain(each.argument.value.wire)) for each in fields]
