"""Datatypes of fields: the catalogue's, so that everybody who knows a signal's path finds the same message."""

from collections.abc import Mapping
from typing import NamedTuple

from sigcat.catalogue.model.datatypes import element_of, is_array
from sigcat.function.function_json.datatype import Datatype, Symbol
from sigcat.integration.datatypes import BY_VSS, Spelling, of_reference


class FieldType(NamedTuple):
    """Datatype of a field."""

    element: Spelling | None
    """Its primitive, or that of its elements; None for a struct."""
    struct: str = ""
    """Reference of the struct, if it is one."""
    suffix: str = ""
    """`[]` or `[50]` for an array."""
    symbols: tuple[Symbol, ...] = ()
    """Values of an enumeration, with the numbers that the code has for them."""

    @property
    def is_text(self) -> bool:
        """Whether the field holds text."""
        return self.element is not None and self.element.vss == "string"


def field_type(reference: str, vss: str | None, table: Mapping[str, Datatype]) -> FieldType | None:
    """Datatype of a field by that of the catalogue, or else of the code. None if neither can be resolved."""
    stored = table.get(reference)
    suffix = _suffix(stored, vss)
    element = _element(stored, table)
    symbols = (element.symbols or ()) if element else ()
    if vss and element_of(vss) in BY_VSS:
        return FieldType(BY_VSS[element_of(vss)], "", suffix, symbols)
    if element is not None and element.kind == "struct":
        return FieldType(None, element.reference, suffix)
    primitive = code_type(reference, table)
    return FieldType(primitive, "", suffix, symbols) if primitive else None


def code_type(reference: str, table: Mapping[str, Datatype]) -> Spelling | None:
    """The primitive that the code has, or that its elements have; None for a struct."""
    element = _element(table.get(reference), table)
    if element is None:
        return of_reference(reference)
    return None if element.kind == "struct" else of_reference(element.reference, element.c_definition)


def c_definition(reference: str, table: Mapping[str, Datatype]) -> str:
    """How C writes the datatype."""
    stored = table.get(reference)
    return stored.c_definition if stored else reference


def _element(stored: Datatype | None, table: Mapping[str, Datatype]) -> Datatype | None:
    """The datatype itself, or the innermost element of an array. Arrays that contain themselves have none."""
    seen: set[str] = set()
    while stored is not None and stored.kind == "array":
        if stored.reference in seen:
            return None
        seen.add(stored.reference)
        stored = table.get(stored.element or "")
    return stored


def _suffix(stored: Datatype | None, vss: str | None) -> str:
    is_list = (stored is not None and stored.kind == "array") or (vss is not None and is_array(vss))
    if not is_list:
        return ""
    length = stored.length if stored is not None and stored.kind == "array" else None
    return f"[{length}]" if length else "[]"
