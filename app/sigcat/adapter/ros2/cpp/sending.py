"""What a node sends."""

from typing import Any

from sigcat.adapter.core.plan import Port
from sigcat.adapter.ros2.cpp.layout import any_of, call, comment, function, indented, scope, text
from sigcat.adapter.ros2.cpp.names import CORE, LOCK, core_function, is_plain, short, table
from sigcat.adapter.ros2.plan import Given, NodePlan, Publisher
from sigcat.function.document.text_filters import c_string


def publish_function(node: NodePlan) -> str:
    """Sends what the core says, outside of its lock."""
    uses_out = bool(node.publishers)
    requests = [scope(f"if (due.{each.method.named.name})", [f"request_{each.member}();"]) for each in node.used]
    told = [f"due.{given.place}" for each in node.publishers if each.is_status for given in each.gives]
    published = f"{core_function(node, 'Published')}({CORE});"
    head = f"void {node.type}::publish({_argument(node)})"
    if not (uses_out or requests):
        return function(head, [LOCK, published])
    return function(head, [
        "const std::lock_guard<std::mutex> publishing(publishing_mutex_);",
        "decltype(core_->adapter.out) out{};" if uses_out else "",
        "decltype(core_->adapter.publish) due{};",
        scope("", [LOCK, "out = core_->adapter.out;" if uses_out else "", "due = core_->adapter.publish;", published]),
        *(_sent(each, node) for each in node.publishers),
        *requests,
        f"{any_of(told)}\n  tell();\n}}" if told else "",
    ])  # fmt: skip


def _argument(node: NodePlan) -> str:
    return f"const builtin_interfaces::msg::Time &{' stamp' if any(each.stamp for each in node.publishers) else ' /* stamp */'}"


def _sent(publisher: Publisher, node: NodePlan) -> str:
    due = [f"due.{each.place}" for each in publisher.gives]
    if publisher.is_queue:
        place = publisher.gives[0].place
        loop = f"for (uint32_t i = 0; i < out.{place}.count; ++i)"
        body = scope(loop, [_message(publisher, node, f"out.{place}.values[i]")])
    else:
        body = _message(publisher, node, "")
    return f"{any_of(due)}\n{indented(body)}\n}}"


def _message(publisher: Publisher, node: NodePlan, queued: str) -> str:
    return text([
        f"{short(publisher.message, node)} message;",
        f"message.{publisher.stamp} = stamp;" if publisher.stamp else "",
        *(f"message.{each.field} = {_fixed(each.value)};" for each in publisher.fixed),
        *(text([comment(each.comment, levels=3), _filled(each, queued or f"out.{each.place}")]) for each in publisher.gives),
        "" if publisher.is_status else f"complete_{publisher.member}(message);",
        f"{publisher.member}_publisher_->publish(message);",
        *(_taken_back(port, queued or f"out.{each.place}", f"due.{each.place}", node, is_alone=len(publisher.gives) == 1)
          for each in publisher.gives for port in each.own_ports),
    ])  # fmt: skip


def _fixed(value: Any) -> str:
    """A value of a document, as C++ writes it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    return repr(value) if isinstance(value, int | float) else c_string(value)


def _filled(given: Given, value: str) -> str:
    field, is_one = f"message.{given.field}", is_plain(given.wire)
    number = f"message.{given.number_field}" if given.number_field else ""
    if given.symbols:
        name = table(given.place)
        written = f"{field} = symbol_text({name}, {value});" if is_one else f"assign_texts({name}, {value}, {field});"
        return text([written, (f"{number} = {value};" if is_one else f"assign({value}, {number});") if number else ""])
    if given.numbers:
        (first, one), (second, other) = given.numbers
        assert (one, other) == (0, 1), first
        return f"{field} = {value} == {second}U ? 1U : 0U;"
    return f"{field} = {value};" if is_one else f"assign({value}, {field});"


def _taken_back(port: Port, value: str, due: str, node: NodePlan, *, is_alone: bool) -> str:
    """Another call of the function takes what this one sends: no message is needed for that."""
    argument = f"&{value}" if port.wire.is_struct and port.wire.length is None else value
    take = call(core_function(node, f"Receive_{port.name}"), [CORE, argument, "clock_->now()"], levels=3)
    if not port.triggers:
        return scope("" if is_alone else f"if ({due})", [LOCK, take])
    body = [scope("", [LOCK, take]), "clock_->wake();"]
    return text(body) if is_alone else scope(f"if ({due})", body)
