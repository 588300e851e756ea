"""Calls of a function, and the variables that are declared nowhere else."""

import re
from collections.abc import Iterator

from sigcat import codes
from sigcat.adapter.core.numbers import type_of_c
from sigcat.adapter.core.plan import CLASS, GLOBALS, Code, CodeObject, Extern
from sigcat.adapter.core.planning import Context
from sigcat.function.document.document import Pointer
from sigcat.function.function_json.code import CodeInterface
from sigcat.function.function_json.datatypes.datatype import innermost
from sigcat.function.function_json.variables import variables

_PLAIN = re.compile(r"[A-Za-z_]\w*", re.ASCII)
ADAPTER = "Adapter"


def planned_code(context: Context) -> Code:
    """Sources, headers and calls of the code. Without `Code`, calls are plain functions over globals."""
    declared = context.function.code or CodeInterface(signature=GLOBALS)
    objects = tuple(CodeObject(each.name, each.type, each.member, each.length) for each in declared.objects or ())
    if declared.signature == CLASS and not declared.class_name:
        message = "The class that has the calls as members must have a name."
        context.report(codes.VARIABLE_MISSING, ("Code",), message, "Give `class`.")
    externs: dict[str, Extern] = {}
    for name, at, extern in _externs(declared, context):
        if extern is not None:
            externs.setdefault(name, extern)
        elif not declared.headers and declared.signature == GLOBALS:
            message = f"The type of {name} is not known: no header declares it."
            context.report(codes.HEADER_MISSING, at, message, "Name the header under `code`, `headers`.")
    held = tuple(each for each in objects if declared.signature != GLOBALS or _is_defined_here(declared, each.name))
    return Code(
        signature=declared.signature,
        headers=declared.headers or (),
        objects=held,
        class_name=declared.class_name,
        externs=tuple(externs.values()),
        sources=declared.sources or (),
        include_folders=declared.include_folders or (),
        definitions=tuple(each.as_option for each in declared.definitions or ()),
    )


def _is_defined_here(declared: CodeInterface, name: str) -> bool:
    return any(each.name == name and each.defined_by == ADAPTER for each in declared.objects or ())


def _externs(declared: CodeInterface, context: Context) -> Iterator[tuple[str, Pointer, Extern | None]]:
    """Variables that the adapter defines, or that no header declares; None where they have no plain type."""
    if declared.signature != GLOBALS:
        return
    roots = {each.name for each in declared.objects or ()}
    for each in sorted(variables(context.function), key=lambda one: one.c_type is None):
        name = _PLAIN.match(each.expression)
        if name is None or name[0] in roots or (declared.headers and each.defined_by != ADAPTER):
            continue
        if each.datatype is not None and _is_text(each.datatype, context):  # it cannot be carried anyway
            continue
        plain, length = _plain_type(each.datatype, context) if each.datatype is not None else (None, None)
        c = each.c_type or plain
        is_plain = name[0] == each.expression and c is not None and not (length and each.elements)
        is_here = each.defined_by == ADAPTER
        yield (
            name[0],
            each.pointer[:-1],
            Extern(each.expression, c or "", length or each.elements, is_here) if is_plain else None,
        )


def _is_text(reference: str, context: Context) -> bool:
    datatype = innermost(reference, context.datatypes)
    return datatype is not None and datatype.kind is None and type_of_c(datatype.c_definition) is None


def _plain_type(reference: str, context: Context) -> tuple[str | None, int | None]:
    datatype = context.datatypes.get(reference)
    if datatype is None or datatype.kind == "struct":
        return None, None
    if datatype.kind == "array":
        return _plain_type(datatype.element or "", context)[0], datatype.length
    found = type_of_c(datatype.c_definition)
    return (datatype.c_definition if found else None), None
