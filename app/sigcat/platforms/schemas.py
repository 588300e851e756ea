"""JSON Schemas of every file format that sigcat reads or writes, by name."""

from collections.abc import Callable, Mapping
from typing import Any

from sigcat.errors import NotFound
from sigcat.names import nearest
from sigcat.platforms.table import PLATFORMS


def _deployment() -> dict[str, Any]:
    from sigcat.platforms.deployment_file import deployment_schema

    return deployment_schema()


def _function() -> dict[str, Any]:
    from sigcat.function.function_json.model import function_schema

    return function_schema()


def _declaration() -> dict[str, Any]:
    from sigcat.function.declaration.declaration import declaration_schema

    return declaration_schema()


def _project() -> dict[str, Any]:
    from sigcat.platforms.project_schemas import project_schema

    return project_schema()


def _overlay() -> dict[str, Any]:
    from sigcat.platforms.project_schemas import overlay_schema

    return overlay_schema()


def _rules() -> dict[str, Any]:
    from sigcat.platforms.project_schemas import rules_schema

    return rules_schema()


SCHEMAS: Mapping[str, Callable[[], dict[str, Any]]] = {
    "deployment": _deployment,
    "function": _function,
    "function-declaration": _declaration,
    "overlay": _overlay,
    "project": _project,
    "rules": _rules,
    **{f"integration-{platform.name}": platform.schema for platform in PLATFORMS.values()},
}
"""Each imports its models when it is called, so that their names cost nothing."""


def schema(name: str) -> dict[str, Any]:
    """The schema of a name. Raises NotFound with the nearest names."""
    if name not in SCHEMAS:
        raise NotFound(f"Unknown schema {name!r}.", nearest(name, SCHEMAS))
    return SCHEMAS[name]()
