"""What a node tells people."""

from sigcat.adapter.core.plan import Call
from sigcat.adapter.ros2.cpp.layout import call, function, indented, literal, scope
from sigcat.adapter.ros2.cpp.names import LOCK, report_name, times_name
from sigcat.adapter.ros2.plan import Monitor, NodePlan
from sigcat.function.document.text_filters import c_string


def tell_function(node: NodePlan) -> str:
    """A status of each error, call and topic. Under the lock of the core it only copies: its calls wait for that."""
    return function(f"void {node.type}::tell()", [
        "decltype(diagnostics_) publisher;",
        "decltype(core_->adapter.error) error{};\ndecltype(core_->adapter.stored) stored{};" if node.monitors else "",
        *(f"CallReport {report_name(node, step)};" for step in node.steps),
        "std::string scheduling_problem;\nbool is_active = false;",
        scope("", [
            LOCK,
            "publisher = diagnostics_;",
            "error = core_->adapter.error;\nstored = core_->adapter.stored;" if node.monitors else "",
            *(_reported(step, node) for step in node.steps),
            "scheduling_problem = scheduling_problem_;\nis_active = is_active_;",
        ]),
        "if (publisher == nullptr || publisher->get_subscription_count() == 0U) {\n  return;\n}",
        "diagnostic_msgs::msg::DiagnosticArray told;\ntold.header.stamp = now();",
        "const std::string node = unique_name(get_node_base_interface()->get_fully_qualified_name());",
        "bool has_calls = false;  // whether one runs: the mode may exclude all of them" if node.steps else "",
        *(f"has_calls |= is_active && !{report_name(node, step)}.is_excluded;" for step in node.steps),
        *(_error(each) for each in node.monitors),
        *(call("told.status.push_back", [call("call_status", ["node", c_string(step.interface), report_name(node, step)], ")", 3)])
          for step in node.steps),
        _SCHEDULING if node.priority is not None else scope("if (!scheduling_problem.empty())", [_SCHEDULING]),
        f"topics_.tell(node, {'has_calls' if node.steps else 'is_active'}, told.status);\npublisher->publish(told);",
    ], "// For people and aggregators; what others act on has topics of its own.")  # fmt: skip


def _reported(step: Call, node: NodePlan) -> str:
    place = f"core_->adapter.{step.name}"
    missed = f"{place}.missed" if step.cycle is not None else "0"
    return call(f"{report_name(node, step)} = {times_name(node, step)}.report", [missed, f"{place}.dropped"], levels=2)


def _error(monitor: Monitor) -> str:
    name, diagnostic = monitor.error.named.name, monitor.diagnostic
    error, counts = f"error.{name}", f"stored.{name}"
    members = [
        c_string(monitor.interface),
        literal(diagnostic.message, 4),
        f"DiagnosticStatus::{diagnostic.level}",
        f"static_cast<ErrorState>({error}.state)",
        f"{error}.is_confirmed",
        f"{counts}.occurrences",
        f"{counts}.ignition_cycles",
    ]
    rows = indented(",\n".join(members), 2)
    return f"told.status.push_back(\n  error_status(\n    node, {{\n{rows}}}));"


_SCHEDULING = """told.status.push_back(
  made_status(
    scheduling_problem.empty() ? DiagnosticStatus::OK : DiagnosticStatus::WARN, node,
    "scheduling", scheduling_problem));"""
