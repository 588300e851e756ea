"""Parameter files: every parameter of a node with its default, and what a reader should know of it."""

import json
import textwrap
from collections.abc import Iterator
from typing import Any

from sigcat.adapter.ros2.plan import NodeParameter, NodePlan, WorkspacePlan
from sigcat.function.document.text import Text, composed
from sigcat.function.document.text_filters import AnyText, comment, comment_rows, yaml_string

_WIDEST = 102


def parameter_file(node: NodePlan, workspace: WorkspacePlan) -> str:
    """The text of `config/NODE.yaml`, for the node of this name in any namespace."""
    parts = [*map(_parameter, node.parameters), *_own(node, workspace)]
    body = "\n".join(textwrap.indent(part, "    ") for part in parts)
    head = f"# yaml-language-server: $schema={comment(schema_name(node))}\n"
    head += _comment(f"Parameters of {node.name}: what it has without this file.")
    has_values = any(not line.startswith("#") for part in parts for line in part.splitlines())
    values = "ros__parameters:" if has_values else "ros__parameters: {}"  # rcl refuses a key without a value
    return f"{head}/**/{node.name}:\n  {values}\n{body}"


def schema_name(node: NodePlan) -> str:
    """File of the schema, beside the parameter file."""
    return f"{node.name}.schema.json"


def _own(node: NodePlan, workspace: WorkspacePlan) -> Iterator[str]:
    """What every node has, whatever its function is."""
    if node.priority is not None:
        about = f"Policy of the thread that makes the calls: other, fifo or rr, these with priority {node.priority}."
        yield _comment(about) + f"scheduling_policy: {node.policy}\n"
    if node.is_stored:
        about = "Folder of what the node keeps from one run to the next"
        yield (
            _comment(f"{about}; if empty $ROS_HOME/{workspace.name}, or else ~/.ros/{workspace.name}.")
            + 'storage_folder: ""\n'
        )


def _parameter(parameter: NodeParameter) -> str:
    known = [part for limit in _limits(parameter) for part in ("; ", limit)]
    about = _comment(parameter.description) + _comment(composed(parameter.parameter.named.comment, *known))
    value = _value(parameter.default, parameter.type.removesuffix("_array"))
    if value == "[]":  # a file of parameters has no lists without elements
        return f"{about}# {comment(parameter.name)}: []\n"
    return f"{about}{parameter.name}: {value}\n"


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


def _comment(text: AnyText) -> str:
    return "".join(f"{row}\n" for row in comment_rows(text, "#", _WIDEST))
