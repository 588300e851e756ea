"""Datatypes that interfaces refer to."""

from collections.abc import Mapping

from sigcat.function.document.field_types import CDefinition, Name, UnitKey, VssDatatype
from sigcat.function.document.text import Text
from sigcat.function.function_json.wire import Integer, Listed, Number, TypeReference, WireModel, always, described, own


class EnumerationValue(WireModel):
    """A named value of an enumeration."""

    symbol: Name = always("Symbol", "Name of the value.")
    value: Integer = always("Value", "Its number.")


class TypeField(WireModel):
    """A member of a struct."""

    name: Name = always("Name", "Name of the member.")
    datatype: TypeReference = always("Datatype", "Reference to a datatype of the document.")
    units: UnitKey | None = own("Units", "Unit of the member.")
    description: Text | None = own("Description", "What the member means.")
    min: Number | None = own("Min", "Smallest value of the member.", unit="Units")
    max: Number | None = own("Max", "Largest value of the member.", unit="Units")


class Datatype(WireModel):
    """A datatype that interfaces refer to."""

    reference: TypeReference = described("typeRef", "Name of the datatype, such as DT_UInt16.")
    category: Name = described("category", "primitive or userdefined.")
    c_definition: CDefinition = described("cDef", "Definition in C.")
    kind: Name | None = own("Kind", "enumeration, array or struct, where the datatype is one.")
    vss_datatype: VssDatatype | None = own("VssDatatype", "Datatype of VSS.")
    symbols: Listed[EnumerationValue] | None = own("Symbols", "Values of an enumeration.")
    element: TypeReference | None = own("ElementType", "Datatype of the elements of an array.")
    length: Integer | None = own("Length", "Elements of an array; absent if that is open.", unit="elements")
    fields: Listed[TypeField] | None = own("Fields", "Members of a struct, in order.")
    description: Text | None = own("Description", "What a struct is.")


def innermost(reference: str, known: Mapping[str, Datatype]) -> Datatype | None:
    """The datatype itself, or the innermost element of an array. Arrays that contain themselves have none."""
    datatype, seen = known.get(reference), set[str]()
    while datatype is not None and datatype.kind == "array":
        if datatype.reference in seen:
            return None
        seen.add(datatype.reference)
        datatype = known.get(datatype.element or "")
    return datatype
