"""Methods that the function uses or offers, as services."""

from sigcat.adapter.ros2.cpp.layout import call, function, scope, text
from sigcat.adapter.ros2.cpp.names import CORE, LOCK, core_function, is_plain, scope_of, short
from sigcat.adapter.ros2.plan import ArgumentField, MethodService, NodePlan


def method_functions(node: NodePlan) -> list[str]:
    """Answers to requests of others, and requests of the function."""
    return [*(_answer(each, node) for each in node.offered), *(_request(each, node) for each in node.used)]


def _copied(source: str, target: str, each: ArgumentField) -> str:
    return f"{target} = {source};" if is_plain(each.argument.value.wire) else f"assign({source}, {target});"


def _answer(each: MethodService, node: NodePlan) -> str:
    core, name = node.core.type_name, each.method.named.name
    arguments = [CORE, *(["&arguments"] if each.request else []), *(["&results"] if each.response else [])]
    good = f"reply == {scope_of(node).constant('OK')}"
    type_ = short(each.service, node)
    request = "request" if each.request else "/* request */"
    return function(f"void {node.type}::answer_{each.member}(\n  const {type_}::Request & {request}, {type_}::Response & response)", [
        f"{core}_{name}_Arguments arguments{{}};" if each.request else "",
        f"{core}_{name}_Results results{{}};" if each.response else "",
        *(_copied(f"request.{one.field}", f"arguments.{one.argument.name}", one) for one in each.request),
        "const std::lock_guard<std::mutex> call(call_mutex_);",
        call(f"const {core}_Reply reply = {core_function(node, f'Method_{name}')}", arguments),
        f"response.{each.success} = {good};",
        *(_copied(f"results.{one.argument.name}", f"response.{one.field}", one) for one in each.response),
    ])  # fmt: skip


def _request(each: MethodService, node: NodePlan) -> str:
    core, name = node.core.type_name, each.method.named.name
    type_, client = short(each.service, node), f"{each.member}_client_"
    results = [f"{core}_{name}_Results results{{}};"] if each.response else []
    given = ["&results"] if each.response else []
    answer = core_function(node, f"Answer_{name}")
    missing = text(
        [*results, LOCK, call(answer, [CORE, "asked.number", "false", *given, "clock_->now()"], levels=2), "return;"]
    )
    taken = [_copied(f"response->{one.field}", f"results.{one.argument.name}", one) for one in each.response]
    return function(f"void {node.type}::request_{each.member}()", [
        f"decltype(core_->adapter.method.{name}) asked{{}};",
        scope("", [LOCK, f"asked = core_->adapter.method.{name};"]),
        scope(f"if (!{client}->service_is_ready())", [missing]),
        f"const auto request = std::make_shared<{type_}::Request>();",
        *(_copied(f"asked.arguments.{one.argument.name}", f"request->{one.field}", one) for one in each.request),
        f"{client}->prune_pending_requests();  // one at a time: others are too late",
        f"{client}->async_send_request(\n  request,",
        f"  [this, number = asked.number](const rclcpp::Client<{type_}>::SharedFuture answer) {{",
        *("    " + row for row in text([
            "const auto response = answer.get();",
            *results, *taken, LOCK,
            call(answer, [CORE, "number", f"response->{each.success}", *given, "clock_->now()"], levels=3),
        ]).split("\n")),
        "  });",
    ])  # fmt: skip
