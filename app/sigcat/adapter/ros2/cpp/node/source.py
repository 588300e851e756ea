"""The source of a node."""

from sigcat.adapter.core.c.names.scope import Scope
from sigcat.adapter.core.plan import GLOBALS
from sigcat.adapter.ros2.cpp.names import header_of, table
from sigcat.adapter.ros2.cpp.node.connections import duration, unnamed
from sigcat.adapter.ros2.cpp.node.header import has_messages
from sigcat.adapter.ros2.cpp.node.node_calls import stems_of
from sigcat.adapter.ros2.cpp.node.parameters import AS, cpp_type, default_of, limits_of, range_of, unset
from sigcat.adapter.ros2.cpp.node.sending import active, literal
from sigcat.adapter.ros2.cpp.node.stored import learned_places
from sigcat.adapter.ros2.cpp.node.tables import symbols_of
from sigcat.adapter.ros2.package_xml import rights
from sigcat.adapter.ros2.plan import NodePlan, WorkspacePlan
from sigcat.adapter.templates import rendered


def node_source(node: NodePlan, workspace: WorkspacePlan) -> str:
    """The whole source."""
    return rendered(
        "adapter/ros2/cpp/node/node.cpp.j2",
        rights=rights(workspace.package),
        node=node,
        headers=_headers(node, workspace),
        package=workspace.name,
        interfaces=workspace.interfaces,
        # Whether it has messages of the set, and its header none.
        has_new_messages=has_messages(node, node.subscriptions) and not has_messages(node, node.publishers),
        type=node.type,
        core=node.core.type_name,  # the type of the core, with which names of its functions and types begin
        macro=Scope(node.core).macro,  # names of its constants begin with it
        # Whether a process can have one node of it: the code has its data in global variables.
        is_once=node.core.code.signature == GLOBALS,
        has_bond=workspace.has_bond,
        has_deadline=node.core.has_deadline,
        stems=stems_of(node),  # of the names that it has for calls
        table=table,
        symbols=symbols_of(node),
        learned=learned_places(node),
        cpp_type=cpp_type,
        default_of=default_of,
        range_of=range_of,
        limits_of=limits_of,
        getters=AS,
        unset=unset(node) if node.settable else (),
        # Whether the release tells when all have accepted: others may refuse what this node does not.
        has_taken_callback=workspace.release != "humble",
        duration=duration,
        unnamed=unnamed,
        literal=literal,
        active=active,
        has_stamp=any(each.stamp for each in node.publishers),
        # Places of the core for which diagnostics are sent at once.
        statuses=[given.place for each in node.publishers if each.is_status for given in each.gives],
        services_quality="rmw_qos_profile_services_default"
        if workspace.release == "humble"
        else "rclcpp::ServicesQoS()",
    )


def main_source(node: NodePlan, workspace: WorkspacePlan) -> str:
    """The source of the node's own executable."""
    return rendered(
        "adapter/ros2/cpp/node/main.cpp.j2", rights=rights(workspace.package), package=workspace.name, node=node
    )


def _headers(node: NodePlan, workspace: WorkspacePlan) -> list[str]:
    own = ["diagnostics", "guard", "parameters", "values", *(["scheduling"] if node.priority is not None else [])]
    own += ["bond"] if workspace.has_bond else []
    own += [f"{node.name}_structs"] if node.structs else []
    headers = [f"{workspace.name}/{each}.hpp" for each in own]
    headers += [header_of(each.message) for each in node.subscriptions]
    return sorted({*headers, node.core.header_file})
