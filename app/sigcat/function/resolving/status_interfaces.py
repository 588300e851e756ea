"""Errors that a call reports, and safety conditions that it reacts to, as the catalogue declares them."""

from typing import Any

from sigcat.catalogue.model.catalogue import Node
from sigcat.catalogue.model.interfaces import function_of, interface_name
from sigcat.function.declaration.declaration import ErrorItem, ReactionItem
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Subject
from sigcat.function.document.text import Text, optional
from sigcat.function.function_json.datatypes.type_list import symbols_of
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface, SafetyReaction
from sigcat.function.function_json.resolved_function import Origin
from sigcat.function.resolving.code import word
from sigcat.function.resolving.context import Context
from sigcat.function.resolving.interfaces import Attributes, interface_node
from sigcat.function.resolving.part import Part, written
from sigcat.function.resolving.values.numbers import plain_text


def error(item: ErrorItem, at: Pointer, context: Context) -> Part[ErrorInterface]:
    """An error of the function itself."""
    node = interface_node(item.interface, "error", at, context, own=True)
    if node is None:
        return Part(None, Origin(at), (Subject("error", item.interface),))
    attributes = Attributes(node, at, context)
    made = ErrorInterface(
        dependencies=attributes.texts("dependency"),
        occurrence_count_limit=item.occurrence_count_limit,
        ignition_count_limit=item.ignition_count_limit,
        maturation_time=attributes.number("maturationTime") or 0,
        severity=Text(attributes.text("severity") or ""),
        reset_time=attributes.number("resetTime"),
        reset_condition=optional(attributes.text("resetCondition")),
        status_variable=item.status_variable,
        reset=_reset(item.reset, context),
        **_common(item, attributes),
    )
    return Part(made, Origin(at, written(item, at)))


def _reset(reference: str | None, context: Context) -> str | None:
    """`restart`, or a signal given by path or name; whether the function consumes it is checked with the result."""
    return word(reference) if reference == "restart" else context.signals.get(reference or "", reference)


def safety_reaction(item: ReactionItem, at: Pointer, context: Context) -> Part[SafetyReaction]:
    """A safety condition, of this function or of another."""
    node = interface_node(item.interface, "safety_reaction", at, context)
    if node is None:
        return Part(None, Origin(at))
    attributes = Attributes(node, at, context)
    made = SafetyReaction(
        errors=attributes.texts("errorList"),
        initial=item.initial,
        timeout=plain_text(item.timeout),
        **_common(item, attributes),
    )
    return Part(made, Origin(at, written(item, at)))


def _common(item: ErrorItem | ReactionItem, attributes: Attributes) -> dict[str, Any]:
    """Fields that errors and safety reactions have."""
    node = attributes.node
    return {
        "name": interface_name(node.path),
        "description": attributes.description,
        "datatype": _datatype(node, attributes.context),
        "asil_level": attributes.asil,
        "vss_path": node.path,
        "variable": item.variable,
        "defined_by": word(item.defined_by),
        "c_type": item.c_type,
    }


def _datatype(node: Node, context: Context) -> str:
    """Reference to the datatype of an error or a safety reaction; all of a function share one enumeration."""
    suffix = interface_name(node.path).rpartition("_")[2]
    name = f"{node.template.partition('.')[0]}.{function_of(node.path)}.{suffix}"
    return context.types.reference(str(node.values.get("datatype")), name, symbols_of(node))
