"""Modes of a function, and the interfaces over which it takes and reports them."""

from typing import Any

from sigcat import codes
from sigcat.catalogue.model.interfaces import interface_name
from sigcat.function.declaration.declaration import ActiveMode, ModeInItem, ModeOutItem, ModesItem
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem, Subject
from sigcat.function.document.text import Text
from sigcat.function.function_json.datatypes.type_list import listed, symbols_of
from sigcat.function.function_json.interfaces.status_interfaces import ModeInterface
from sigcat.function.function_json.model import Mode
from sigcat.function.function_json.resolved_function import Origin
from sigcat.function.resolving.code import word
from sigcat.function.resolving.context import Context
from sigcat.function.resolving.interfaces import error_name, interface_node
from sigcat.function.resolving.part import Part, each, written


def mode(item: ActiveMode, at: Pointer, context: Context) -> Part[Mode]:
    """A mode; whether the function has the calls that run in it is checked with the result."""
    calls = tuple(context.call_name(reference) for reference in item.runnables)
    made = Mode(name=item.mode, description=Text(item.description), runnables=calls)
    return Part(made, Origin(at, written(item, at)))


def mode_interfaces(item: ModesItem, at: Pointer, context: Context) -> list[Part[ModeInterface]]:
    """The mode interfaces, each with what the declaration says of its side in the code."""
    parts = each(item.interfaces, (*at, "interfaces"), context, _mode_interface)
    sides = {"In": (item.in_, (*at, "in")), "Out": (item.out, (*at, "out"))}
    made = []
    for part in parts:
        side, place = sides.get(part.value.direction, (None, at)) if part.value else (None, at)
        made.append(part if side is None else _with_code(part, side, place, context))
    listed = {part.value.direction for part in parts if part.value}
    context.problems.extend(
        (
            _without_interface(name, place, context)
            for name, (side, place) in sides.items()
            if side and name not in listed
        )
    )
    return made


def _without_interface(direction: str, at: Pointer, context: Context) -> Problem:
    name = f"{context.function}_Mode_{direction}"
    message = f"The code has a variable of {name}, but the function does not list this interface."
    return Problem(codes.MODE_WITHOUT_INTERFACE, at, message, "Add it to `interfaces`.", Subject("mode", name))


def _with_code(part: Part[ModeInterface], item: ModeOutItem, at: Pointer, context: Context) -> Part[ModeInterface]:
    assert part.value is not None
    fields: dict[str, Any] = {
        "variable": item.variable,
        "defined_by": word(item.defined_by),
        "c_type": item.c_type,
        "values": listed(item.values) if item.values else None,
    }
    if isinstance(item, ModeInItem):
        error = error_name(item.unknown_error, (*at, "unknownError"), context)
        fields |= {"initial": item.initial, "unknown_action": word(item.unknown), "unknown_error": error}
    return Part(part.value.model_copy(update=fields), Origin(part.origin.pointer, written(item, at)))


def _mode_interface(reference: str, at: Pointer, context: Context) -> Part[ModeInterface]:
    node = interface_node(reference, "mode", at, context, own=True)
    if node is None:
        return Part(None, Origin(at))
    symbols = symbols_of(node)
    name = f"{context.function}.{context.function}.Mode{node.name}"
    made = ModeInterface(
        name=interface_name(node.path),
        description=Text(str(node.values.get("description") or "")),
        direction=node.name,
        datatype=context.types.reference(str(node.values.get("datatype")), name, symbols),
        modes=tuple(symbols or ()),
        vss_path=node.path,
    )
    return Part(made, Origin(at))
