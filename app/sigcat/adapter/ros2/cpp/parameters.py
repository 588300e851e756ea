"""Parameters of a node: declared with their descriptors, and handed to the core."""

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

from sigcat.adapter.ros2.cpp.layout import call, literal
from sigcat.adapter.ros2.cpp.names import table
from sigcat.adapter.ros2.plan import NodeParameter, NodePlan, WorkspacePlan
from sigcat.function.document.text_filters import AnyText, c_string

_CPP = {"bool": "bool", "integer": "int64_t", "double": "double", "string": "std::string"}
AS = {
    "bool": "as_bool", "integer": "as_int", "double": "as_double", "string": "as_string", "bool_array": "as_bool_array",
    "integer_array": "as_integer_array", "double_array": "as_double_array", "string_array": "as_string_array",
}  # fmt: skip
"""Functions of rclcpp that return a parameter of each type."""


class Settable(NamedTuple):
    """A parameter that may change while the node runs, and the expression that takes its value."""

    name: str
    taken: str


class Parameters(NamedTuple):
    """All parameters of a node."""

    declared: Sequence[str]
    """Statements that declare them."""
    settable: Sequence[Settable]
    """All that the core's SetParameters takes."""
    start_values: Sequence[str]
    """Statements that give the core start values that are not its own, which are exact."""
    unset: Sequence[str]
    """Parameters of the core that the node has none for: structs."""
    refusal: str
    """The call that finds the reason of a refusal."""
    has_taken_callback: bool
    """Whether the release tells when all have accepted: others may refuse what this node does not."""


def parameters_of(node: NodePlan, workspace: WorkspacePlan) -> Parameters:
    """All of a node."""
    return Parameters(
        [*_own(node, workspace), *(_declared(each) for each in node.parameters)],
        [Settable(each.name, _taken(each)) for each in node.settable],
        [_start_value(each) for each in node.parameters],
        _unset(node) if node.settable else (),
        call("refusal", ["parameters", _all_limits(node)], ");", 2),
        workspace.release != "humble",
    )


def _own(node: NodePlan, workspace: WorkspacePlan) -> list[str]:
    """Those that every node has, whatever its function is."""
    found = [_fixed("bool", "lock_step", "false", "Whether the service ~/step gives the time: for tests and replays.")]
    if node.priority is not None:
        words = f"Policy of the thread that runs the calls, with priority {node.priority}."
        found.append(_fixed("std::string", "scheduling_policy", c_string(node.policy), words, "one of other, fifo, rr"))
        found.append('check_policy(get_parameter("scheduling_policy").as_string());')
    if node.is_stored:
        words = (
            f"Folder of the values that the node keeps; $ROS_HOME/{workspace.name} or ~/.ros/{workspace.name} if empty."
        )
        found.append(_fixed("std::string", "storage_folder", '""', words))
    return found


def _fixed(cpp: str, name: str, default: str, words: str, constraints: str = "") -> str:
    """The declaration of a parameter that cannot be changed while the node runs."""
    return _declaration(cpp, name, default, call("fixed", [_described(words, constraints, 3)], ")", 2))


def _described(words: AnyText, constraints: AnyText, levels: int) -> str:
    """A descriptor, on one line if it fits."""
    arguments = [literal(words, levels + 1), *([literal(constraints, levels + 1)] if constraints else [])]
    return call("described", arguments, ")", levels)


def _declaration(cpp: str, name: str, default: str, descriptor: str) -> str:
    return call(f"declare_parameter<{cpp}>", [c_string(name), default, descriptor])


def _cpp_type(parameter: NodeParameter) -> str:
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
    return _declaration(_cpp_type(parameter), parameter.name, _default(parameter), descriptor)


def _limits(parameter: NodeParameter) -> tuple[str, str]:
    if parameter.type == "double":
        low, high = (None if each is None else _double(each) for each in (parameter.low, parameter.high))
        return low or "std::numeric_limits<double>::lowest()", high or "std::numeric_limits<double>::max()"
    low, high = (None if each is None else f"int64_t{{{round(each)}}}" for each in (parameter.low, parameter.high))
    return low or "std::numeric_limits<int64_t>::min()", high or "std::numeric_limits<int64_t>::max()"


def _default(parameter: NodeParameter) -> str:
    """The default as an expression of its type."""
    element = parameter.type.removesuffix("_array")
    if parameter.type.endswith("_array"):
        values = ", ".join(_value(each, element) for each in parameter.default)
        return f"{_cpp_type(parameter)}{{{values}}}"
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


def _all_limits(node: NodePlan) -> str:
    """Limits of those that have some; one that has none of a kind has those of every number."""
    own = ", ".join(
        f"{{{c_string(each.name)}, {_double(-math.inf if each.low is None else each.low)}, {_double(math.inf if each.high is None else each.high)}}}"
        for each in node.settable
        if each.low is not None or each.high is not None
    )
    return f"{{{own}}}"


def _taken(parameter: NodeParameter) -> str:
    place = f"changed.{parameter.parameter.named.name}"
    text_table = f"{table(parameter.parameter.named.name)}, " if parameter.symbols else ""
    return f"take({text_table}parameter.{AS[parameter.type]}(), {place})"


def _start_value(parameter: NodeParameter) -> str:
    name = parameter.parameter.named.name
    text_table = f"{table(name)}, " if parameter.symbols else ""
    got = f"get_parameter({c_string(parameter.name)}).{AS[parameter.type]}()"
    return call("start_with", [f"{text_table}{got}", _default(parameter), f"stored.{name}"])


def _unset(node: NodePlan) -> Sequence[str]:
    known = {each.parameter.named.name for each in node.parameters}
    names = [each.named.name for each in node.core.parameters if each.learned is None]
    return [name for name in names if name not in known]
