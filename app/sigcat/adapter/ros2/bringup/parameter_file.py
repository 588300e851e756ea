"""Parameter files: every parameter of a node with its default, and what a reader should know of it."""

import json
from collections.abc import Iterator, Sequence
from typing import Any, NamedTuple

from sigcat.adapter.ros2.plan import NodeParameter, NodePlan, WorkspacePlan
from sigcat.adapter.templates import rendered
from sigcat.function.document.text import Text, composed
from sigcat.function.document.text_filters import AnyText, yaml_string


class _Entry(NamedTuple):
    name: str
    about: Sequence[AnyText]
    value: str | None
    """None if it is a list without elements, which a file of parameters cannot have."""


class _ParameterFile(NamedTuple):
    node: str
    schema: str
    has_values: bool
    """Whether there is a value; rcl refuses a key without one."""
    entries: Sequence[_Entry]


def parameter_file(node: NodePlan, workspace: WorkspacePlan) -> str:
    """The text of `config/NODE.yaml`, for the node of this name in any namespace."""
    entries = [*map(_entry, node.parameters), *_own(node, workspace)]
    has_values = any(entry.value is not None for entry in entries)
    plan = _ParameterFile(node.name, schema_name(node), has_values, entries)
    return rendered("adapter/ros2/bringup/parameters.yaml.j2", plan)


def schema_name(node: NodePlan) -> str:
    """File of the schema, beside the parameter file."""
    return f"{node.name}.schema.json"


def _own(node: NodePlan, workspace: WorkspacePlan) -> Iterator[_Entry]:
    """Parameters of every node, whatever its function is."""
    if node.priority is not None:
        about = f"Policy of the thread that makes the calls: other, fifo or rr, these with priority {node.priority}."
        yield _Entry("scheduling_policy", [about], node.policy)
    if node.is_stored:
        folders = f"if empty $ROS_HOME/{workspace.name}, or else ~/.ros/{workspace.name}"
        about = f"Folder of the values that the node keeps between runs; {folders}."
        yield _Entry("storage_folder", [about], '""')


def _entry(parameter: NodeParameter) -> _Entry:
    known = [part for limit in _limits(parameter) for part in ("; ", limit)]
    about = [parameter.description, composed(parameter.parameter.named.comment, *known)]
    is_empty = isinstance(parameter.default, list | tuple) and not parameter.default
    value = None if is_empty else _value(parameter.default, parameter.type.removesuffix("_array"))
    return _Entry(parameter.name, about, value)


def _limits(parameter: NodeParameter) -> Iterator[AnyText]:
    if parameter.low is not None:
        yield f"at least {json.dumps(parameter.low)}"
    if parameter.high is not None:
        yield f"at most {json.dumps(parameter.high)}"
    if parameter.constraints:
        yield parameter.constraints
    if parameter.is_learned:
        yield "the function learns it; this is what it starts from"
    elif parameter.is_read_only:
        yield "only read when the node starts"


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
