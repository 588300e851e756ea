"""JSON Schemas of every file format that sigcat reads or writes for functions, by name."""

from collections.abc import Callable, Mapping
from typing import Any

from sigcat.errors import NotFound
from sigcat.function.declaration.declaration import declaration_schema
from sigcat.function.function_json.model import function_schema
from sigcat.integration.autosar_adaptive.model import integration_schema
from sigcat.integration.deployment import deployment_schema
from sigcat.integration.ros2.model import ros2_schema
from sigcat.names import nearest

SCHEMAS: Mapping[str, Callable[[], dict[str, Any]]] = {
    "deployment": deployment_schema,
    "function": function_schema,
    "function-declaration": declaration_schema,
    "integration-autosar-adaptive": integration_schema,
    "integration-ros2": ros2_schema,
}


def schema(name: str) -> dict[str, Any]:
    """The schema of a name. Raises NotFound with the nearest names."""
    if name not in SCHEMAS:
        raise NotFound(f"There is no schema {name!r}.", nearest(name, SCHEMAS))
    return SCHEMAS[name]()
