"""Parameters of a node: declared with their descriptors, and handed to the core."""

import math
from typing import Any

from sigcat.adapter.ros2.cpp.layout import call, function, literal, scope
from sigcat.adapter.ros2.cpp.names import CORE, LOCK, core_function, table
from sigcat.adapter.ros2.plan import NodeParameter, NodePlan, WorkspacePlan
from sigcat.function.document.text_filters import AnyText, c_string

_CPP = {"bool": "bool", "integer": "int64_t", "double": "double", "string": "std::string"}
AS = {
    "bool": "as_bool", "integer": "as_int", "double": "as_double", "string": "as_string", "bool_array": "as_bool_array",
    "integer_array": "as_integer_array", "double_array": "as_double_array", "string_array": "as_string_array",
}  # fmt: skip
"""How rclcpp gives a parameter of each type."""


def parameter_functions(node: NodePlan, workspace: WorkspacePlan) -> list[str]:
    """What declares the parameters, and what takes changes of them."""
    return [_declare(node, workspace), *([_set(node)] if node.settable else [])]


def _declare(node: NodePlan, workspace: WorkspacePlan) -> str:
    return function(f"void {node.type}::declare_parameters()", [
        *_own(node, workspace),
        *(_declared(each) for each in node.parameters),
        _checked(node, workspace) if node.settable else "",
    ])  # fmt: skip


def _own(node: NodePlan, workspace: WorkspacePlan) -> list[str]:
    """Those that every node has, whatever its function is."""
    words = "Whether the service ~/step gives the time: for tests and replays."
    found = [_declaration("bool", "lock_step", "false", call("fixed", [_described(words, "", 3)], ")", 2))]
    if node.priority is not None:
        words = f"Policy of the thread that runs the calls, with priority {node.priority}."
        descriptor = _described(words, "one of other, fifo, rr", 3)
        fixed = call("fixed", [descriptor], ")", 2)
        found.append(_declaration("std::string", "scheduling_policy", c_string(node.policy), fixed))
        found.append('check_policy(get_parameter("scheduling_policy").as_string());')
    if node.is_stored:
        words = f"Folder of what the node keeps; $ROS_HOME/{workspace.name} or ~/.ros/{workspace.name} if empty."
        descriptor = _described(words, "", 3)
        found.append(_declaration("std::string", "storage_folder", '""', call("fixed", [descriptor], ")", 2)))
    return found


def _described(words: AnyText, constraints: AnyText, levels: int) -> str:
    """A descriptor, on one line if it fits."""
    arguments = [literal(words, levels + 1), *([literal(constraints, levels + 1)] if constraints else [])]
    return call("described", arguments, ")", levels)


def _declaration(cpp: str, name: str, default: str, descriptor: str) -> str:
    return call(f"declare_parameter<{cpp}>", [c_string(name), default, descriptor])


def cpp_type(parameter: NodeParameter) -> str:
    """Type of a parameter as the node has it."""
    element = _CPP[parameter.type.removesuffix("_array")]
    return f"std::vector<{element}>" if parameter.type.endswith("_array") else element


def _declared(parameter: NodeParameter) -> str:
    has_range = parameter.low is not None or parameter.high is not None
    levels = 2 + has_range + parameter.is_read_only
    descriptor = _described(parameter.described, parameter.constraints or "", levels)
    if has_range:
        descriptor = call("within", [descriptor, *_limits(parameter)], ")", levels - 1)
    if parameter.is_read_only:
        descriptor = call("fixed", [descriptor], ")", 2)
    return _declaration(cpp_type(parameter), parameter.name, default_of(parameter), descriptor)


def _limits(parameter: NodeParameter) -> tuple[str, str]:
    if parameter.type == "double":
        low, high = (None if each is None else _double(each) for each in (parameter.low, parameter.high))
        return low or "std::numeric_limits<double>::lowest()", high or "std::numeric_limits<double>::max()"
    low, high = (None if each is None else f"int64_t{{{round(each)}}}" for each in (parameter.low, parameter.high))
    return low or "std::numeric_limits<int64_t>::min()", high or "std::numeric_limits<int64_t>::max()"


def default_of(parameter: NodeParameter) -> str:
    """The default as an expression of its type."""
    element = parameter.type.removesuffix("_array")
    if parameter.type.endswith("_array"):
        values = ", ".join(_value(each, element) for each in parameter.default)
        return f"{cpp_type(parameter)}{{{values}}}"
    return _value(parameter.default, element)


def _value(value: Any, element: str) -> str:
    if element == "bool":
        return "true" if value else "false"
    if element == "integer":
        return "INT64_MIN" if value == -(2**63) else f"int64_t{{{int(value)}}}"
    return f"std::string({c_string(value)})" if element == "string" else _double(value)


def _double(value: float) -> str:
    number = float(value)
    if math.isinf(number):
        return f"{'-' if number < 0 else ''}std::numeric_limits<double>::infinity()"
    if not math.isfinite(number):
        return "std::numeric_limits<double>::quiet_NaN()"
    return repr(number)


# -- changes ------------------------------------------------------------------------------------------------------


def _checked(node: NodePlan, workspace: WorkspacePlan) -> str:
    """Others may refuse what this node does not: what all have accepted is taken, except on Humble, which does not tell."""
    names = ",\n  ".join(c_string(each.name) for each in node.settable)
    is_told = workspace.release != "humble"
    taken = """
taken_callback_ = add_post_set_parameters_callback(
  [this](const std::vector<rclcpp::Parameter> & parameters) {set(parameters, false);});""" if is_told else ""  # fmt: skip
    return f"""const std::vector<std::string> names = {{
  {names}}};
const rcl_interfaces::msg::SetParametersResult result = set(get_parameters(names), false);
if (!result.successful) {{
  throw rclcpp::exceptions::InvalidParameterValueException(result.reason);
}}
parameters_callback_ = add_on_set_parameters_callback(
  [this](const std::vector<rclcpp::Parameter> & parameters) {{
    return set(parameters, {"true" if is_told else "false"});
  }});{taken}"""


def _set(node: NodePlan) -> str:
    core = node.core.type_name
    known = [each for each in node.core.parameters if each.learned is None]
    asks = f"{core_function(node, 'SetParameters')}({CORE}, &changed)"
    if len(known) > len(node.settable):  # the start values of the others are known by then
        asks = f"!is_initialized_ || {asks}"
    takes = [
        scope(f"if (name == {c_string(each.name)})", [f"is_taken = {_taken(each)};"])
        for each in node.settable
    ]  # fmt: skip
    return function(f"rcl_interfaces::msg::SetParametersResult {node.type}::set(\n  const std::vector<rclcpp::Parameter> & parameters, bool is_only_checked)", [
        LOCK,
        "rcl_interfaces::msg::SetParametersResult result;\nresult.successful = true;",
        f"{core}_Parameters changed = core_->parameters;\nbool has_changed = false;",
        scope("for (const rclcpp::Parameter & parameter : parameters)", [
            "const std::string & name = parameter.get_name();\nbool is_taken = true;",
            _chain([*takes, "{\n  continue;  // not of the function\n}"]),
            "has_changed = true;",
            scope("if (!is_taken)", ['result.successful = false;\nresult.reason = name + " has no such value";']),
        ]),
        scope("if (!result.successful || !has_changed)", ["return result;"]),
        f"const auto before = core_->adapter.parameter;\nresult.successful = {asks};",
        scope("if (result.successful && is_only_checked)", ["core_->adapter.parameter = before;"],
              "} else if (result.successful) {\n  core_->parameters = changed;\n} else {"),
        f"  result.reason = {call('refusal', ['parameters', _all_limits(node)], ');', 2)}\n}}",
        "return result;",
    ], "// All of them, or none.")  # fmt: skip


def _all_limits(node: NodePlan) -> str:
    """Limits of those that have some; one that has none of a kind has those of every number."""
    own = ", ".join(
        f"{{{c_string(each.name)}, {_double(-math.inf if each.low is None else each.low)}, {_double(math.inf if each.high is None else each.high)}}}"
        for each in node.settable
        if each.low is not None or each.high is not None
    )
    return f"{{{own}}}"


def _chain(branches: list[str]) -> str:
    return " else ".join(branches)


def _taken(parameter: NodeParameter) -> str:
    place = f"changed.{parameter.parameter.named.name}"
    text_table = f"{table(parameter.parameter.named.name)}, " if parameter.symbols else ""
    return f"take({text_table}parameter.{AS[parameter.type]}(), {place})"


def initial_parameters(node: NodePlan) -> list[str]:
    """What the core starts from, where it is not its own start value, which is exact."""
    found = []
    for each in node.parameters:
        name = each.parameter.named.name
        text_table = f"{table(name)}, " if each.symbols else ""
        got = f"get_parameter({c_string(each.name)}).{AS[each.type]}()"
        found.append(call("start_with", [f"{text_table}{got}", default_of(each), f"stored.{name}"]))
    return found
