"""Parameter files: every parameter of a node with its default, and what a reader should know of it."""

import json
from typing import Any

from sigcat.adapter.ros2.plan import NodeParameter, NodePlan, WorkspacePlan
from sigcat.adapter.templates import rendered
from sigcat.function.document.text import Text
from sigcat.function.document.text_filters import yaml_string


def parameter_file(node: NodePlan, workspace: WorkspacePlan) -> str:
    """The text of `config/NODE.yaml`, for the node of this name in any namespace."""
    has_own = node.priority is not None or node.core.is_stored
    has_values = has_own or any(_value_of(each) is not None for each in node.parameters)
    return rendered(
        "adapter/ros2/bringup/parameters.yaml.j2",
        node=node,
        package=workspace.name,
        schema=schema_name(node),
        has_values=has_values,  # whether there is a value; rcl refuses a key without one
        value_of=_value_of,
        dumps=json.dumps,
    )


def schema_name(node: NodePlan) -> str:
    """File of the schema, beside the parameter file."""
    return f"{node.name}.schema.json"


def _value_of(parameter: NodeParameter) -> str | None:
    """The default; None if it is a list without elements, which a file of parameters cannot have."""
    is_empty = isinstance(parameter.default, list | tuple) and not parameter.default
    return None if is_empty else _value(parameter.default, parameter.type.removesuffix("_array"))


def _value(value: Any, element: str) -> str:
    if isinstance(value, list | tuple):
        listed = ", ".join(_value(each, element) for each in value)
        return f"[{listed}]"
    if element == "double":
        return _double(float(value))
    return yaml_string(value) if isinstance(value, Text) else json.dumps(value)


def _double(value: float) -> str:
    """With a point, by which a file of parameters tells it from an integer."""
    digits, mark, exponent = repr(value).partition("e")
    return f"{digits}{'' if '.' in digits else '.0'}{mark}{exponent}"
