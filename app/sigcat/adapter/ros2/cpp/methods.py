"""Methods that the function uses or offers, as services."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.ros2.cpp.layout import call
from sigcat.adapter.ros2.cpp.names import CORE, core_function, is_plain, short
from sigcat.adapter.ros2.plan import ArgumentField, MethodService, NodePlan, WorkspacePlan
from sigcat.function.document.text_filters import c_string


class Copied(NamedTuple):
    """A field of a request or response, and the argument or result of the core that is copied from or to it."""

    field: str
    argument: str
    is_plain: bool


class Offered(NamedTuple):
    """A method of the function, which answers requests of others."""

    member: str
    topic: str
    type: str
    method: str
    request: Sequence[Copied]
    response: Sequence[Copied]
    success: str | None
    called: str
    """The call of the core."""


class Used(NamedTuple):
    """A method of another function, which this one requests."""

    member: str
    type: str
    method: str
    request: Sequence[Copied]
    response: Sequence[Copied]
    given_up: str
    """The call of the core when no answer is received."""
    answered: str
    """The call of the core with the answer."""
    client: str
    """The statement that creates its client."""


class Methods(NamedTuple):
    """All methods of a node."""

    quality: str
    """Quality of service of services, as the release takes it."""
    offered: Sequence[Offered]
    used: Sequence[Used]


def methods_of(node: NodePlan, workspace: WorkspacePlan) -> Methods:
    """All that it offers and uses."""
    quality = "rmw_qos_profile_services_default" if workspace.release == "humble" else "rclcpp::ServicesQoS()"
    return Methods(
        quality,
        [_offered(each, node) for each in node.offered],
        [_used(each, node, quality) for each in node.used],
    )


def _offered(each: MethodService, node: NodePlan) -> Offered:
    name = each.method.named.name
    arguments = [CORE, *(["&arguments"] if each.request else []), *(["&results"] if each.response else [])]
    return Offered(
        each.member,
        node.private(each.topic),
        short(each.service, node),
        name,
        _copied(each.request),
        _copied(each.response),
        each.success,
        call(f"const {node.core.type_name}_Reply reply = {core_function(node, f'Method_{name}')}", arguments),
    )


def _used(each: MethodService, node: NodePlan, quality: str) -> Used:
    name = each.method.named.name
    answer = core_function(node, f"Answer_{name}")
    rest = [*(["&results"] if each.response else []), "clock_->now()"]
    return Used(
        each.member,
        short(each.service, node),
        name,
        _copied(each.request),
        _copied(each.response),
        call(answer, [CORE, "asked.number", "false", *rest], levels=2),
        call(answer, [CORE, "number", f"response->{each.success}", *rest], levels=3),
        call(
            f"{each.member}_client_ = create_client<{short(each.service, node)}>",
            [c_string(each.topic), quality, "answering_"],
        ),
    )


def _copied(fields: Sequence[ArgumentField]) -> Sequence[Copied]:
    return [Copied(each.field, each.argument.name, is_plain(each.argument.value.wire)) for each in fields]
