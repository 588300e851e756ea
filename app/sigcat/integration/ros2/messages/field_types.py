"""Datatypes of fields: the catalogue's, so that everybody who knows a signal's path finds the same message."""

from collections.abc import Mapping
from typing import NamedTuple

from sigcat.catalogue.model.datatypes import element_of, is_array
from sigcat.function.function_json.datatypes.datatype import Datatype, EnumerationValue, innermost
from sigcat.function.function_json.datatypes.type_list import smallest_integer
from sigcat.integration.datatypes import BY_VSS, Spelling, of_reference


class FieldType(NamedTuple):
    """Datatype of a field."""

    element: Spelling | None
    """Its primitive, or that of its elements; None for a struct."""
    struct: str = ""
    """Reference of the struct, if it is one."""
    suffix: str = ""
    """`[]` or `[50]` for an array."""
    symbols: tuple[EnumerationValue, ...] = ()
    """Values of an enumeration, with the numbers that the code has for them, or those that are sent."""

    @property
    def is_text(self) -> bool:
        """Whether the field holds text."""
        return self.element is not None and self.element.vss == "string"


def field_type(reference: str, vss: str | None, table: Mapping[str, Datatype]) -> FieldType | None:
    """Datatype of a field by that of the catalogue, or else of the code. None if neither can be resolved."""
    stored = table.get(reference)
    suffix = _suffix(stored, vss)
    element = innermost(reference, table)
    symbols = (element.symbols or ()) if element else ()
    if vss and element_of(vss) in BY_VSS:
        return FieldType(BY_VSS[element_of(vss)], "", suffix, symbols)
    if element is not None and element.kind == "struct":
        return FieldType(None, element.reference, suffix)
    primitive = code_type(reference, table)
    return FieldType(primitive, "", suffix, symbols) if primitive else None


def sent(kind: FieldType, symbols: tuple[EnumerationValue, ...] | None, *, as_number: bool = False) -> FieldType:
    """Return the message's type for a datatype of the code: an enumeration has the numbers of the catalogue."""
    kind = kind._replace(symbols=symbols or kind.symbols)
    return number_of(kind) if as_number and kind.is_text and kind.symbols else kind


def number_of(kind: FieldType) -> FieldType:
    """The integer that holds the numbers of an enumeration."""
    numbers = {symbol.symbol: symbol.value for symbol in kind.symbols}
    return kind._replace(element=BY_VSS[smallest_integer(numbers)])


def symbols_of(reference: str, table: Mapping[str, Datatype]) -> tuple[EnumerationValue, ...]:
    """Values of an enumeration, or of the elements of an array, with the numbers of the code."""
    datatype = innermost(reference, table)
    return (datatype.symbols or ()) if datatype else ()


def code_type(reference: str, table: Mapping[str, Datatype]) -> Spelling | None:
    """The primitive that the code has, or that its elements have; None for a struct."""
    element = innermost(reference, table)
    if element is None:
        return of_reference(reference)
    return None if element.kind == "struct" else of_reference(element.reference, element.c_definition)


def c_definition(reference: str, table: Mapping[str, Datatype]) -> str:
    """Definition of the datatype in C."""
    stored = table.get(reference)
    return stored.c_definition if stored else reference


def _suffix(stored: Datatype | None, vss: str | None) -> str:
    is_list = (stored is not None and stored.kind == "array") or (vss is not None and is_array(vss))
    if not is_list:
        return ""
    length = stored.length if stored is not None and stored.kind == "array" else None
    return f"[{length}]" if length else "[]"
