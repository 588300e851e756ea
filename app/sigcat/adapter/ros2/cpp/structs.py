"""Structs of messages and of the core, copied member by member."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.ros2.cpp.names import guard, header_of
from sigcat.adapter.ros2.package_xml import rights
from sigcat.adapter.ros2.plan import NodePlan, StructPair, WorkspacePlan
from sigcat.adapter.templates import rendered


class _Member(NamedTuple):
    """Names of a member on both sides."""

    source: str
    target: str


class _Copy(NamedTuple):
    """A specialization that copies one struct to the other."""

    source: str
    target: str
    members: Sequence[_Member]


def structs_header(node: NodePlan, workspace: WorkspacePlan) -> str:
    """The whole header."""
    messages = [header_of(pair.message) for pair in node.structs]
    return rendered(
        "adapter/ros2/cpp/structs.hpp.j2",
        rights=rights(workspace.package),
        name=node.name,
        guard=guard(workspace, f"{node.name}_structs"),
        package=workspace.name,
        headers=sorted([node.core.header_file, f"{workspace.name}/values.hpp", *messages]),
        copies=[copy for pair in node.structs for copy in _copies(pair)],
    )


def _copies(pair: StructPair) -> tuple[_Copy, _Copy]:
    """Copies from the message to the core, and back."""
    message, core = pair.message.cpp, f"::{pair.struct.name}"
    names = [(member, field.name) for field, member in zip(pair.struct.fields, pair.members, strict=True)]
    return (
        _Copy(message, core, [_Member(theirs, ours) for theirs, ours in names]),
        _Copy(core, message, [_Member(ours, theirs) for theirs, ours in names]),
    )
