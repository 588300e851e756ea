"""JSON Schema of a parameter file, for editors and for checks before a node starts."""

import json
from typing import Any

from sigcat.adapter.ros2.plan import NodeParameter, NodePlan
from sigcat.function.document.text_filters import comment

_TYPES = {"bool": "boolean", "integer": "integer", "double": "number", "string": "string"}
_NAME = r"^/?(\*\*/|[a-z][a-z0-9_]*/)*(\*\*|\*|[a-z][a-z0-9_]*)$"
"""A node, with its namespace or wildcards for it."""


def parameter_schema(node: NodePlan) -> str:
    """The text of `config/NODE.schema.json`. Parameters that every node of ROS 2 has are allowed, too."""
    values = {
        "type": "object",
        "additionalProperties": False,
        "properties": {**{each.name: _parameter(each) for each in node.parameters}, **_own(node)},
    }
    schema = {
        "$schema": "http://json-schema.org/draft-07/schema#",
        "title": f"Parameters of {node.name}",
        "type": "object",
        "additionalProperties": False,
        "patternProperties": {_NAME: {"type": "object", "properties": {"ros__parameters": values}}},
    }
    return json.dumps(schema, indent=2) + "\n"


def _own(node: NodePlan) -> dict[str, Any]:
    """Parameters that every node has."""
    found: dict[str, Any] = {"use_sim_time": {"type": "boolean"}, "lock_step": {"type": "boolean"}}
    if node.priority is not None:
        found["scheduling_policy"] = {"enum": ["other", "fifo", "rr"]}
    if node.core.is_stored:
        found["storage_folder"] = {"type": "string"}
    return found | {"qos_overrides": {"type": "object"}}


def _parameter(parameter: NodeParameter) -> dict[str, Any]:
    element: dict[str, Any] = {"type": _TYPES[parameter.type.removesuffix("_array")]}
    if parameter.low is not None:
        element["minimum"] = parameter.low
    if parameter.high is not None:
        element["maximum"] = parameter.high
    if parameter.symbols:
        element["enum"] = [each.text for each in parameter.symbols]
    about = {"description": comment(parameter.described)}
    return about | ({"type": "array", "items": element} if parameter.type.endswith("_array") else element)
