"""What connects a node with others: publishers, subscriptions, services."""

from sigcat.adapter.ros2.cpp.layout import call, comment, function, indented, scope, text
from sigcat.adapter.ros2.cpp.names import (
    CORE,
    LOCK,
    core_function,
    declared,
    is_plain,
    short,
    table,
)
from sigcat.adapter.ros2.plan import MethodService, NodePlan, Publisher, Subscription, Taken, WorkspacePlan
from sigcat.function.document.text_filters import c_string
from sigcat.integration.ros2.model import QualityOfService


def connection_functions(node: NodePlan, workspace: WorkspacePlan) -> list[str]:
    """What makes them, and what drops them."""
    return [
        function(f"void {node.type}::advertise()", [_advertised(each, node) for each in node.publishers]),
        function(f"void {node.type}::subscribe_all()", [_subscribed(each, node) for each in node.subscriptions],
                 "// Subscriptions only store: what is stored is taken by the calls."),
        _offer(node, workspace),
        _disconnect(node),
    ]  # fmt: skip


def quality(of: QualityOfService) -> str:
    """Quality of service in C++."""
    parts = [
        f"rclcpp::QoS(rclcpp::KeepLast({of.depth}))",
        "reliable()" if of.reliability == "reliable" else "best_effort()",
        "transient_local()" if of.durability == "transient_local" else "durability_volatile()",
    ]
    if of.deadline is not None:
        parts.append(f"deadline({_duration(of.deadline)})")
    if of.liveliness == "manual_by_topic":
        parts.append("liveliness(rclcpp::LivelinessPolicy::ManualByTopic)")
        if of.lease_duration is not None:
            parts.append(f"liveliness_lease_duration({_duration(of.lease_duration)})")
    line = ".".join(parts)
    return line if len(line) < 92 else f"{'.'.join(parts[:3])}\n.{'.'.join(parts[3:])}"


def _duration(milliseconds: float) -> str:
    if milliseconds == int(milliseconds):
        return f"std::chrono::milliseconds({int(milliseconds)})"
    return f"std::chrono::nanoseconds({round(milliseconds * 10**6)})"


def _advertised(publisher: Publisher, node: NodePlan) -> str:
    arguments = ["*this", "topics_", c_string(node.private(publisher.topic)), quality(publisher.quality), "receiving_"]
    made = f"std::make_unique<CountingPublisher<{short(publisher.message, node)}>>"
    return f"{publisher.member}_publisher_ =\n  " + call(made, arguments, levels=2)


# -- subscriptions ------------------------------------------------------------------------------------------------


def _subscribed(subscription: Subscription, node: NodePlan) -> str:
    head = f"[this](const {short(subscription.message, node)} & message) {{"
    body = text([LOCK, *(_received(each, node) for each in subscription.takes)])
    if any(each.wakes for each in subscription.takes):
        body = text([scope("", [body]), "clock_->wake();"])
    arguments = [
        f"*this, topics_, {c_string(node.private(subscription.topic))},",
        f"{quality(subscription.quality)}, receiving_,",
        head,
    ]
    return text([
        f"subscriptions_.push_back(\n  subscribe<{short(subscription.message, node)}>(",
        indented(text(arguments), 2),
        indented(body, 3),
        "    }));",
    ])  # fmt: skip


def _received(taken: Taken, node: NodePlan) -> str:
    receive = core_function(node, f"Receive_{taken.place}")
    before, value = _value(taken, f"message.{taken.field}")
    return text([comment(taken.comment, levels=4), before, call(receive, [CORE, value, "clock_->now()"], levels=4)])


def _value(taken: Taken, field: str) -> tuple[str, str]:
    """What comes before the value is handed over, and the value."""
    wire = taken.wire
    if is_plain(wire):
        if taken.symbols:
            return (
                "",
                f"static_cast<{wire.c}>(\n  symbol_number({table(taken.place)}, {field}, {taken.nameless}))",
            )
        return "", _renumbered(taken, field) if taken.numbers else field
    name = f"taken_{taken.place}"
    if taken.symbols:
        assign = f"assign_numbers({table(taken.place)}, {field}, {name}, {taken.nameless});"
    else:
        assign = f"assign({field}, {name});"
    return text([declared(wire, name), assign]), name if wire.length is not None else f"&{name}"


def _renumbered(taken: Taken, field: str) -> str:
    """A state by its name, where the core has other numbers."""
    (inactive, first), (active, second) = taken.numbers
    unnamed = next(number for number in range(256) if number not in (first, second))
    return f"{field} == {active}U ? {second}U : {field} == {inactive}U ? {first}U : {unnamed}U"


# -- services -----------------------------------------------------------------------------------------------------


def _offer(node: NodePlan, workspace: WorkspacePlan) -> str:
    qos = "rmw_qos_profile_services_default" if workspace.release == "humble" else "rclcpp::ServicesQoS()"
    return function(f"void {node.type}::offer()", [
        *(_offered(each, node, qos) for each in node.offered),
        *(_used(each, node, qos) for each in node.used),
        scope("if (step_clock_ != nullptr)", [_service("step_service_", "srv::Step", "~/step", "step", qos)]),
    ])  # fmt: skip


def _offered(each: MethodService, node: NodePlan, qos: str) -> str:
    return _service(
        f"{each.member}_service_", short(each.service, node), node.private(each.topic), f"answer_{each.member}", qos
    )


def _service(member: str, type_: str, name: str, handler: str, qos: str) -> str:
    return f"""{member} = create_service<{type_}>(
  {c_string(name)},
  [this](
    const std::shared_ptr<{type_}::Request> request,
    std::shared_ptr<{type_}::Response> response) {{{handler}(*request, *response);}},
  {qos}, answering_);"""


def _used(each: MethodService, node: NodePlan, qos: str) -> str:
    made = f"{each.member}_client_ = create_client<{short(each.service, node)}>"
    return call(made, [c_string(each.topic), qos, "answering_"])


def _disconnect(node: NodePlan) -> str:
    return function(f"void {node.type}::disconnect()", [
        "receiver_.reset();",
        "diagnostics_timer_.reset();",
        scope("", [LOCK, "diagnostics_.reset();"]),
        "step_service_.reset();",
        *(f"{each.member}_service_.reset();" for each in node.offered),
        *(f"{each.member}_client_.reset();" for each in node.used),
        "subscriptions_.clear();",
        *(f"{each.member}_publisher_.reset();" for each in node.publishers),
        "topics_.clear();",
    ])  # fmt: skip
