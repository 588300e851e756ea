"""Structs of the catalogue as they are received and sent, each after those that it holds."""

from collections.abc import Iterable, Iterator

from sigcat.adapter.core.core_values import struct_name
from sigcat.adapter.core.identifiers import identifier
from sigcat.adapter.core.numbers import type_of_c
from sigcat.adapter.core.plan import WireField, WireStruct
from sigcat.adapter.core.planning import Context
from sigcat.function.function_json.datatypes.datatype import Datatype, TypeField


def wire_structs(references: Iterable[str], context: Context) -> tuple[WireStruct, ...]:
    """The structs that datatypes are made of, each once."""
    found: dict[str, WireStruct] = {}
    for reference in references:
        for struct in _structs(reference, context):
            found.setdefault(struct.name, struct)
    return tuple(found.values())


def _structs(reference: str, context: Context) -> Iterator[WireStruct]:
    datatype = context.datatypes.get(reference)
    if datatype is None:
        return
    if datatype.kind == "array":
        yield from _structs(datatype.element or "", context)
    elif datatype.kind == "struct":
        for field in datatype.fields or ():
            yield from _structs(field.datatype, context)
        fields = tuple(_field(field, context) for field in datatype.fields or ())
        yield WireStruct(struct_name(reference, context), datatype.description or "", fields)


def _field(field: TypeField, context: Context) -> WireField:
    datatype = context.datatypes[field.datatype]
    inner = context.datatypes[datatype.element or ""] if datatype.kind == "array" else datatype
    text = f"[{field.units}]" if field.units else ""
    return WireField(identifier(field.name), _c_name(inner, context), datatype.length, text, field.units or "")


def _c_name(datatype: Datatype, context: Context) -> str:
    if datatype.kind == "struct":
        return struct_name(datatype.reference, context)
    found = type_of_c(datatype.c_definition)
    return found.c if found else datatype.c_definition
