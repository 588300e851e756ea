"""Definitions of a file that nothing refers to."""

from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from pydantic import BaseModel

from sigcat import codes
from sigcat.catalogue.model.interfaces import category_of, interface_name
from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.function.extension.defined_nodes import DefinedNode, Definitions
from sigcat.function.function_json.error_fields import errors_set_by
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import declared_data, parameters, runnables, statuses


def unused_definitions(definitions: Definitions, used: Iterable[str]) -> Problems:
    """Interfaces and types that are defined and not used. `used` are the paths and names in use."""
    nodes = (*definitions.nodes, *definitions.types)
    mentioned = {*used, *(text for node in nodes for text in _texts(node.values))}
    for node in nodes:
        name = interface_name(node.path) or node.path
        if _is_entry(node) and mentioned.isdisjoint((node.path, name)):
            message = f"{name!r} is defined, but nothing in the function refers to it."
            kind = category_of(node.path) or "data"
            is_call = kind == "scheduling"
            place = "under `runnables` of a component" if is_call else "where it is read, provided or reported"
            fix = f"List it {place}, or remove the definition."
            yield Problem(codes.DEFINITION_UNUSED, node.at, message, fix, Subject(kind, node.path))


def _is_entry(node: DefinedNode) -> bool:
    """Whether the author wrote the node for its own sake: neither a branch nor a member of a struct."""
    section = node.at[1]
    is_branch = node.values["type"] == "branch" and section != "scheduling"
    return len(node.at) > len(("define", "data")) and not is_branch and node.values["type"] != "property"


def used_by(function: FunctionJson) -> Iterator[str]:
    """Paths and names of everything that a function refers to."""
    for _, _, item in (*declared_data(function), *parameters(function), *statuses(function)):
        yield item.vss_path or ""
        yield from _errors_referred_to(item)
    for _, _, runnable in runnables(function):
        yield runnable.vss_path or ""
        yield from _errors_referred_to(runnable)
        if watchdog := runnable.watchdog:
            yield from (limits.error_name for limits in (watchdog.alive, watchdog.deadline) if limits)
            yield watchdog.logical_error or ""
    yield from (interface.vss_path or "" for interface in function.mode_interfaces or ())
    yield from (datatype.vss_datatype or "" for datatype in function.datatypes)


def _errors_referred_to(item: BaseModel) -> Iterator[str]:
    """Names of the errors that an interface refers to."""
    for attribute in ("dependencies", "errors"):
        yield from getattr(item, attribute, ())
    yield from (each.error for each in errors_set_by(item))


def _texts(value: Any) -> Iterator[str]:
    """Every text in nested values; an array of a type is one of that type."""
    if isinstance(value, str):
        yield from (value, value.removesuffix("[]"))
    elif isinstance(value, Mapping):
        for each in value.values():
            yield from _texts(each)
    elif isinstance(value, list | tuple):
        for each in value:
            yield from _texts(each)
