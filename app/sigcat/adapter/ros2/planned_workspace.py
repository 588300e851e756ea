"""From an integration and the plans of its cores to the plan of the packages."""

from collections.abc import Iterable, Iterator

from sigcat import codes
from sigcat.adapter.ros2.node_context import NodeContext
from sigcat.adapter.ros2.node_ends import publishers, services, subscriptions
from sigcat.adapter.ros2.node_parameters import monitors, node_parameters
from sigcat.adapter.ros2.plan import InterfaceType, NodePlan, WorkspacePlan
from sigcat.adapter.ros2.structs import struct_pairs
from sigcat.adapter.source_cores import Holder, SourceCores, wrong_holders
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.integration.ros2.model import NodePackage, Ros2Integration
from sigcat.integration.ros2.services import CLIENT, SERVER


def derive(model: Ros2Integration, cores: SourceCores, release: str) -> WorkspacePlan:
    """The plan of the packages. Raises InputRefused if a node does not have its own function, or cannot be written."""
    (package,), (messages,) = model.node_packages or (), model.interface_packages or ()  # the document has one of each
    _refuse(_wrong_holders(package, cores))
    known = {message.name: message for message in messages.messages}
    contexts = [NodeContext(node, cores[node.function], model.communications, known) for node in package.nodes]
    _refuse(found for index, context in enumerate(contexts) for found in _disagreements(index, context))
    _refuse(_mixed_queues(contexts))
    nodes = tuple(_node(context, package.name, messages.name) for context in contexts)
    _refuse(_full_enumerations(nodes))
    return WorkspacePlan(
        application=model.info.function_name,
        package=package,
        interfaces=messages.name,
        namespace=package.nodes[0].namespace,
        release=release,
        has_bond=bool(package.bond),
        nodes=nodes,
    )


_ANEW = "Integrate it again with `sigcat integrate ros2`."


def _refuse(findings: Iterable[Finding]) -> None:
    """Raise InputRefused if there are any."""
    if found := tuple(findings):
        raise InputRefused("The integration cannot become ROS 2 packages.", found)


def _problem(message: str, index: int, fix: str, below: str = "") -> Finding:
    """A problem of a node, by its index."""
    return codes.NOT_WRITABLE_AS_ROS2.finding(message, pointer=f"/NodePackageList/0/Nodes/{index}{below}", fix=fix)


def _wrong_holders(package: NodePackage, cores: SourceCores) -> Iterator[Finding]:
    holders = (
        Holder(node.name, node.function, f"/NodePackageList/0/Nodes/{index}/FunctionName")
        for index, node in enumerate(package.nodes)
    )
    return wrong_holders(holders, cores, codes.NOT_WRITABLE_AS_ROS2, "a node", _ANEW)


def _disagreements(index: int, context: NodeContext) -> Iterator[Finding]:
    """Parts of a node that are not those of its function."""
    own = f"of {context.node.name}, as its function has it."
    diagnosed = {diagnostic.error for diagnostic in context.node.diagnostics}
    for error in context.host.errors:
        if error not in diagnosed:
            yield _problem(f"`Diagnostics` must have the error {error} {own}", index, _ANEW, "/Diagnostics")
    for service in (service for role in (SERVER, CLIENT) for service in context.services(role)):
        method = context.host.methods.get(service.method)
        counts = (len(service.request), len(service.response))
        if method is None:
            yield _problem(f"The service {service.name} must be a method {own}", index, _ANEW)
        elif counts != (len(method.arguments), len(method.results)):
            yield _problem(f"The service {service.name} must have the arguments and results {own}", index, _ANEW)


def _mixed_queues(contexts: Iterable[NodeContext]) -> Iterator[Finding]:
    """Queues in a message with other signals: a queue sends as many messages as it has values, these one."""
    fix = "Set `topics` to `cycle` or `signal` in the deployment file."
    for index, context in enumerate(contexts):
        for publisher in publishers(context):
            for given in publisher.gives if len(publisher.gives) > 1 else ():
                if given.is_queue:
                    message = f"The queue {given.place} must travel alone, and shares the topic {publisher.topic}."
                    yield _problem(message, index, fix)


def _full_enumerations(nodes: Iterable[NodePlan]) -> Iterator[Finding]:
    """Enumerations without an unused number, which a text that is none of their values becomes."""
    fix = "Set `enumerations` to `number` or `both` in the deployment file."
    for index, node in enumerate(nodes):
        for taken in (taken for subscription in node.subscriptions for taken in subscription.takes):
            if taken.symbols and taken.nameless is None:
                message = (
                    f"The enumeration {taken.place} must have an unused number, for texts that are not its values."
                )
                yield _problem(message, index, fix)


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
