"""The source of a node."""

from collections.abc import Sequence
from typing import NamedTuple

from sigcat.adapter.core.plan import GLOBALS
from sigcat.adapter.ros2.cpp.names import header_of, scope_of
from sigcat.adapter.ros2.cpp.node.calls import NodeCall, node_calls
from sigcat.adapter.ros2.cpp.node.connections import Connections, connections_of
from sigcat.adapter.ros2.cpp.node.header import has_deadline, has_messages
from sigcat.adapter.ros2.cpp.node.methods import Methods, methods_of
from sigcat.adapter.ros2.cpp.node.parameters import Parameters, parameters_of
from sigcat.adapter.ros2.cpp.node.sending import Sending, sending_of
from sigcat.adapter.ros2.cpp.node.stored import Learned, learned_parameters
from sigcat.adapter.ros2.cpp.node.tables import SymbolTable, symbol_tables
from sigcat.adapter.ros2.package_xml import rights
from sigcat.adapter.ros2.plan import NodePlan, WorkspacePlan
from sigcat.adapter.templates import rendered
from sigcat.function.document.text_filters import AnyText


class _Main(NamedTuple):
    """Plan of the main function of the node's own executable. Two threads beside the one that receives: one answers, one changes the state."""

    rights: AnyText
    package: str
    node: NodePlan


class _Source(NamedTuple):
    """Plan of the source."""

    rights: AnyText
    node: NodePlan
    headers: Sequence[str]
    package: str
    interfaces: str
    has_new_messages: bool
    """Whether it has messages of the set, and its header none."""
    type: str
    core: str
    """The type of the core, with which names of its functions and types begin."""
    macro: str
    """Names of its constants begin with it."""
    is_once: bool
    """Whether a process can have one node of it: the code has its data in global variables."""
    has_bond: bool
    has_deadline: bool
    calls: Sequence[NodeCall]
    tables: Sequence[SymbolTable]
    learned: Sequence[Learned]
    parameters: Parameters
    connections: Connections
    sending: Sending
    methods: Methods


def node_source(node: NodePlan, workspace: WorkspacePlan) -> str:
    """The whole source."""
    plan = _Source(
        rights(workspace.package),
        node,
        _headers(node, workspace),
        workspace.name,
        workspace.interfaces,
        has_messages(node, node.subscriptions) and not has_messages(node, node.publishers),
        node.type,
        node.core.type_name,
        scope_of(node).macro,
        node.core.code.signature == GLOBALS,
        workspace.has_bond,
        has_deadline(node),
        node_calls(node),
        symbol_tables(node),
        learned_parameters(node),
        parameters_of(node, workspace),
        connections_of(node),
        sending_of(node),
        methods_of(node, workspace),
    )
    return rendered("adapter/ros2/cpp/node/node.cpp.j2", plan)


def main_source(node: NodePlan, workspace: WorkspacePlan) -> str:
    """The source of the node's own executable."""
    return rendered("adapter/ros2/cpp/node/main.cpp.j2", _Main(rights(workspace.package), workspace.name, node))


def _headers(node: NodePlan, workspace: WorkspacePlan) -> list[str]:
    own = ["diagnostics", "guard", "parameters", "values", *(["scheduling"] if node.priority is not None else [])]
    own += ["bond"] if workspace.has_bond else []
    own += [f"{node.name}_structs"] if node.structs else []
    headers = [f"{workspace.name}/{each}.hpp" for each in own]
    headers += [header_of(each.message) for each in node.subscriptions]
    return sorted({*headers, node.core.header_file})
