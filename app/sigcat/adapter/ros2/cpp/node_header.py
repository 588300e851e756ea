"""The header of a node."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from sigcat.adapter.ros2.cpp.layout import WIDEST
from sigcat.adapter.ros2.cpp.names import guard, header_of, run_name, short, times_name
from sigcat.adapter.ros2.package_xml import rights
from sigcat.adapter.ros2.plan import NodePlan, Publisher, Subscription, WorkspacePlan
from sigcat.adapter.templates import rendered
from sigcat.function.document.text import composed
from sigcat.function.document.text_filters import AnyText


class _Member(NamedTuple):
    """A member of the node for a topic or a service, and the class of its message or service."""

    member: str
    type: str


class _Call(NamedTuple):
    """Names of the function that runs a call, and of the member that has its times."""

    run: str
    times: str


class _Header(NamedTuple):
    """Plan of the header."""

    rights: AnyText
    about: AnyText
    guard: str
    headers: Sequence[str]
    package: str
    interfaces: str
    type: str
    has_messages: bool
    hooks: Sequence[_Member]
    """Publishers whose messages a derived class may complete: transitions are virtual, too."""
    calls: Sequence[_Call]
    publishers: Sequence[str]
    """Declarations of their members."""
    offered: Sequence[_Member]
    used: Sequence[_Member]
    is_settable: bool
    has_taken_callback: bool
    has_deadline: bool
    is_stored: bool
    has_bond: bool


def node_header(node: NodePlan, workspace: WorkspacePlan) -> str:
    """The whole header."""
    version = f" {node.core.version}" if node.core.version else ""
    plan = _Header(
        rights(workspace.package),
        composed(f"{node.core.function}{version}: ", node.core.description),
        guard(workspace, node.stem),
        _headers(node, workspace),
        workspace.name,
        workspace.interfaces,
        node.type,
        has_messages(node, node.publishers),
        hooks=[_Member(each.member, short(each.message, node)) for each in node.publishers if not each.is_status],
        calls=[_Call(run_name(node, step), times_name(node, step)) for step in node.steps],
        publishers=[_declared(each, node) for each in node.publishers],
        offered=[_Member(each.member, short(each.service, node)) for each in node.offered],
        used=[_Member(each.member, short(each.service, node)) for each in node.used],
        is_settable=bool(node.settable),
        has_taken_callback=workspace.release != "humble",
        has_deadline=has_deadline(node),
        is_stored=node.is_stored,
        has_bond=workspace.has_bond,
    )
    return rendered("adapter/ros2/cpp/node.hpp.j2", plan)


def has_messages(node: NodePlan, ends: Iterable[Publisher | Subscription]) -> bool:
    """Whether a message of the set is among those of some topics."""
    return any(node.is_own(each.message) for each in ends)


def has_deadline(node: NodePlan) -> bool:
    """Whether a call may be late while it runs."""
    return any(step.deadline for step in node.steps)


def _headers(node: NodePlan, workspace: WorkspacePlan) -> list[str]:
    messages = {each.message for each in node.publishers} | {each.service for each in (*node.offered, *node.used)}
    own = ["clock", "diagnostics", "receiver", "topics"]
    own += [*(["storage"] if node.is_stored else []), *(["watch"] if has_deadline(node) else [])]
    headers = [header_of(each) for each in {*messages, node.step_service}]
    headers += [f"{workspace.name}/{each}.hpp" for each in own]
    headers += ["diagnostic_msgs/msg/diagnostic_array.hpp", "rclcpp/rclcpp.hpp", "rclcpp_lifecycle/lifecycle_node.hpp"]
    return sorted(headers)


def _declared(publisher: Publisher, node: NodePlan) -> str:
    """The member, on one line if it fits."""
    type_ = f"std::unique_ptr<CountingPublisher<{short(publisher.message, node)}>>"
    line = f"{type_} {publisher.member}_publisher_;"
    return line if len(line) + 2 <= WIDEST else f"{type_}\n{publisher.member}_publisher_;"
