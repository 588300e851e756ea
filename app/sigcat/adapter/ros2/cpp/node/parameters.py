"""Parameters of a node: declared with their descriptors, and handed to the core."""

import math
from collections.abc import Sequence
from typing import Any, NamedTuple

from sigcat.adapter.ros2.plan import NodeParameter, NodePlan
from sigcat.function.document.text_filters import c_string

_CPP = {"bool": "bool", "integer": "int64_t", "double": "double", "string": "std::string"}
AS = {
    "bool": "as_bool", "integer": "as_int", "double": "as_double", "string": "as_string", "bool_array": "as_bool_array",
    "integer_array": "as_integer_array", "double_array": "as_double_array", "string_array": "as_string_array",
}  # fmt: skip
"""Functions of rclcpp that return a parameter of each type."""


class Range(NamedTuple):
    """The limits of a parameter, as C++ writes them."""

    low: str
    high: str


def limits_of(parameter: NodeParameter) -> Range:
    """Limits of which a refusal tells: those of every number where it has none."""
    low, high = parameter.low, parameter.high
    return Range(_double(-math.inf if low is None else low), _double(math.inf if high is None else high))


def cpp_type(parameter: NodeParameter) -> str:
    """Type of a parameter as the node has it."""
    element = _CPP[parameter.type.removesuffix("_array")]
    return f"std::vector<{element}>" if parameter.type.endswith("_array") else element


def range_of(parameter: NodeParameter) -> Range | None:
    """The range of its descriptor, with a limit of its type where it has none; None if it has no limits."""
    if parameter.low is None and parameter.high is None:
        return None
    element = "double" if parameter.type == "double" else "int64_t"
    least = "lowest" if element == "double" else "min"
    low, high = (None if each is None else _limit(each, element) for each in (parameter.low, parameter.high))
    return Range(low or f"std::numeric_limits<{element}>::{least}()", high or f"std::numeric_limits<{element}>::max()")


def _limit(value: float, element: str) -> str:
    return _double(value) if element == "double" else f"int64_t{{{round(value)}}}"


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


def unset(node: NodePlan) -> Sequence[str]:
    """Parameters of the core that the node has none for: structs."""
    known = {each.parameter.named.name for each in node.parameters}
    names = [each.named.name for each in node.core.parameters if each.learned is None]
    return [name for name in names if name not in known]
