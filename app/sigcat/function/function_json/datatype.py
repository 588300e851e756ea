"""Datatypes that interfaces refer to."""

from collections.abc import Mapping

from sigcat.function.document.field_types import CDefinition, Name, UnitKey, VssDatatype
from sigcat.function.document.text import Text
from sigcat.function.function_json.wire import OWN, Integer, Number, TypeReference, WireModel, described


class EnumerationValue(WireModel):
    """A named value of an enumeration."""

    symbol: Name = described("Symbol", "Name of the value.", source=OWN)
    value: Integer = described("Value", "Its number.", source=OWN)


class TypeField(WireModel):
    """A member of a struct."""

    name: Name = described("Name", "Name of the member.", source=OWN)
    datatype: TypeReference = described("Datatype", "Reference to a datatype of the document.", source=OWN)
    units: UnitKey | None = described("Units", "Unit of the member.", default=None, source=OWN)
    description: Text | None = described("Description", "What the member means.", default=None, source=OWN)
    min: Number | None = described("Min", "Smallest value of the member.", default=None, source=OWN, unit="Units")
    max: Number | None = described("Max", "Largest value of the member.", default=None, source=OWN, unit="Units")


class Datatype(WireModel):
    """A datatype that interfaces refer to."""

    reference: TypeReference = described("typeRef", "Name of the datatype, such as DT_UInt16.")
    category: Name = described("category", "primitive or userdefined.")
    c_definition: CDefinition = described("cDef", "Definition in C.")
    kind: Name | None = described(
        "Kind", "enumeration, array or struct, where the datatype is one.", default=None, source=OWN
    )
    vss_datatype: VssDatatype | None = described("VssDatatype", "Datatype of VSS.", default=None, source=OWN)
    symbols: tuple[EnumerationValue, ...] | None = described(
        "Symbols", "Values of an enumeration.", default=None, source=OWN, strict=False
    )
    element: TypeReference | None = described(
        "ElementType", "Datatype of the elements of an array.", default=None, source=OWN
    )
    length: Integer | None = described(
        "Length", "Elements of an array; absent if that is open.", default=None, source=OWN, unit="elements"
    )
    fields: tuple[TypeField, ...] | None = described(
        "Fields", "Members of a struct, in order.", default=None, source=OWN, strict=False
    )
    description: Text | None = described("Description", "What a struct is.", default=None, source=OWN)


def innermost(reference: str, known: Mapping[str, Datatype]) -> Datatype | None:
    """The datatype itself, or the innermost element of an array. Arrays that contain themselves have none."""
    datatype, seen = known.get(reference), set[str]()
    while datatype is not None and datatype.kind == "array":
        if datatype.reference in seen:
            return None
        seen.add(datatype.reference)
        datatype = known.get(datatype.element or "")
    return datatype
