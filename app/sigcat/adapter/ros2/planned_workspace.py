"""From an integration and the plans of its cores to the plan of the packages."""

from collections.abc import Iterable, Iterator

from sigcat import codes
from sigcat.adapter.host.plan import HostPlan
from sigcat.adapter.ros2.node_context import NodeContext
from sigcat.adapter.ros2.node_ends import mixed_queues, publishers, services, subscriptions
from sigcat.adapter.ros2.node_parameters import monitors, node_parameters
from sigcat.adapter.ros2.plan import InterfaceType, NodePlan, WorkspacePlan
from sigcat.adapter.ros2.structs import struct_pairs
from sigcat.adapter.source_cores import Holder, SourceCores, wrong_holders
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.integration.ros2.model import NodePackage, Ros2Integration, RosNode
from sigcat.integration.ros2.services import CLIENT, SERVER


def derive(model: Ros2Integration, cores: SourceCores, release: str) -> WorkspacePlan:
    """The plan of the packages. Raises InputRefused if a node does not have its own function, or cannot be written."""
    (package,), (messages,) = model.node_packages or (), model.interface_packages or ()  # the document has one of each
    _refuse_shared(package, cores)
    contexts = [_context(node, cores[node.function], model) for node in package.nodes]
    _refuse_disagreements(contexts)
    _refuse_mixed_queues(contexts)
    nodes = tuple(_node(context, package.name, messages.name) for context in contexts)
    _refuse_full_enumerations(nodes)
    return WorkspacePlan(
        application=model.info.function_name,
        package=package,
        interfaces=messages.name,
        namespace=package.nodes[0].namespace,
        release=release,
        has_bond=bool(package.bond),
        nodes=nodes,
    )


def _context(node: RosNode, host: HostPlan, model: Ros2Integration) -> NodeContext:
    messages = {message.name: message for each in model.interface_packages or () for message in each.messages}
    return NodeContext(node, host, model.communications, messages)


def _refuse_disagreements(contexts: Iterable[NodeContext]) -> None:
    """Compare each node of a document with its function."""
    found = [
        _problem(
            f"{message} of {context.node.name}, as its function has it.", f"/NodePackageList/0/Nodes/{index}{below}"
        )
        for index, context in enumerate(contexts)
        for message, below in _disagreements(context)
    ]
    if found:
        raise _refused(found)


def _disagreements(context: NodeContext) -> Iterator[tuple[str, str]]:
    diagnosed = {diagnostic.error for diagnostic in context.node.diagnostics}
    for error in context.host.errors:
        if error not in diagnosed:
            yield f"`Diagnostics` must have the error {error}", "/Diagnostics"
    for service in (service for role in (SERVER, CLIENT) for service in context.services(role)):
        method = context.host.methods.get(service.method)
        counts = (len(service.request), len(service.response))
        if method is None:
            yield f"The service {service.name} must be a method", ""
        elif counts != (len(method.arguments), len(method.results)):
            yield f"The service {service.name} must have the arguments and results", ""


def _refuse_mixed_queues(contexts: Iterable[NodeContext]) -> None:
    """A queue sends as many messages as it has values, the signals beside it one."""
    found = [
        _problem(
            f"The queue {mixed.signal} must travel alone, and shares the topic {mixed.topic}.",
            f"/NodePackageList/0/Nodes/{index}",
            "Set `topics` to `cycle` or `signal` in the deployment file.",
        )
        for index, context in enumerate(contexts)
        for mixed in mixed_queues(context)
    ]
    if found:
        raise _refused(found)


def _refuse_full_enumerations(nodes: Iterable[NodePlan]) -> None:
    """A text that is none of an enumeration becomes a number that is none of it either."""
    found = [
        _problem(
            f"The enumeration {taken.place} must have an unused number, for texts that are not its values.",
            f"/NodePackageList/0/Nodes/{index}",
            "Set `enumerations` to `number` or `both` in the deployment file.",
        )
        for index, node in enumerate(nodes)
        for subscription in node.subscriptions
        for taken in subscription.takes
        if taken.symbols and taken.nameless is None
    ]
    if found:
        raise _refused(found)


def _refuse_shared(package: NodePackage, cores: SourceCores) -> None:
    holders = (
        Holder(node.name, node.function, f"/NodePackageList/0/Nodes/{index}/FunctionName")
        for index, node in enumerate(package.nodes)
    )
    if found := list(wrong_holders(holders, cores, codes.NOT_WRITABLE_AS_ROS2, "a node", _ANEW)):
        raise _refused(found)


_ANEW = "Integrate it again with `sigcat integrate ros2`."


def _problem(message: str, pointer: str, fix: str = _ANEW) -> Finding:
    return codes.NOT_WRITABLE_AS_ROS2.finding(message, pointer=pointer, fix=fix)


def _refused(findings: Iterable[Finding]) -> InputRefused:
    return InputRefused("The integration cannot become ROS 2 packages.", tuple(findings))


def _node(context: NodeContext, package: str, interfaces: str) -> NodePlan:
    node = context.node
    priorities = [schedule.thread_priority for schedule in node.schedules if schedule.thread_priority is not None]
    return NodePlan(
        name=node.name,
        package=package,
        host=context.host,
        executable=node.executable,
        priority=max(priorities, default=None),
        policy=node.scheduling_policy or "other",
        subscriptions=subscriptions(context),
        publishers=publishers(context),
        offered=services(context, "Server"),
        used=services(context, "Client"),
        parameters=tuple(node_parameters(context)),
        monitors=tuple(monitors(context)),
        structs=struct_pairs(context, interfaces),
        step_service=InterfaceType(interfaces, "srv", "Step"),
        error_status=InterfaceType(interfaces, "msg", "ErrorStatus"),
        safety_reaction=InterfaceType(interfaces, "msg", "SafetyReaction"),
    )
