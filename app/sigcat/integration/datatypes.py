"""Primitive datatypes in the spelling of every language that takes part. One row for each; no other table says it.

VSS, reference and C come from the function room; the rest is what C++, AUTOSAR, the two published integration
schemas and ROS 2 call the same thing.
"""

from collections.abc import Mapping
from typing import NamedTuple

from sigcat.catalogue.model.datatypes import element_of
from sigcat.function.function_json.datatypes.datatype import Datatype
from sigcat.function.function_json.datatypes.primitive_types import (
    BY_REFERENCE,
    PRIMITIVES,
    agree,
    c_type,
    reference_type,
)


class Spelling(NamedTuple):
    """One primitive datatype."""

    vss: str
    reference: str
    """Name in Function JSON: `DT_UInt8`."""
    c: str
    cpp: str
    autosar: str
    """Short name of the implementation datatype of AUTOSAR adaptive."""
    adaptive: str
    """Word of `NumericalDatatypes` in the published schema for AUTOSAR adaptive; `string` stands outside of it."""
    ros2: str
    """Built-in type of a ROS 2 message."""
    classic: str
    """Platform type of AUTOSAR Classic, as Platform_Types.h has it; empty for a text, which has none."""


_OTHERS = {
    # vss: C++, AUTOSAR adaptive, published adaptive schema, ROS 2, AUTOSAR Classic
    "boolean": ("bool", "bool", "bool", "bool", "boolean"),
    "uint8": ("std::uint8_t", "uint8_t", "uint8_t", "uint8", "uint8"),
    "int8": ("std::int8_t", "int8_t", "int8_t", "int8", "sint8"),
    "uint16": ("std::uint16_t", "uint16_t", "uint16_t", "uint16", "uint16"),
    "int16": ("std::int16_t", "int16_t", "int16_t", "int16", "sint16"),
    "uint32": ("std::uint32_t", "uint32_t", "uint32", "uint32", "uint32"),
    "int32": ("std::int32_t", "int32_t", "int32", "int32", "sint32"),
    "uint64": ("std::uint64_t", "uint64_t", "uint64", "uint64", "uint64"),
    "int64": ("std::int64_t", "int64_t", "int64", "int64", "sint64"),
    "float": ("float", "float", "float", "float32", "float32"),
    "double": ("double", "double", "double", "float64", "float64"),
    "string": ("std::string", "String", "string", "string", ""),
}

SPELLINGS = tuple(Spelling(row.vss, row.reference, row.c, *_OTHERS[row.vss]) for row in PRIMITIVES)
BY_VSS = {row.vss: row for row in SPELLINGS}
BY_ADAPTIVE = {row.adaptive: row for row in SPELLINGS} | {"float32": next(r for r in SPELLINGS if r.vss == "float")}
"""The published schema has two words for one datatype: `float` and `float32`."""

_BY_KIND = {(meant.kind, meant.bits): row for row in SPELLINGS if (meant := c_type(row.c))}


def of_reference(reference: str, c_definition: str = "") -> Spelling | None:
    """The primitive of a document's reference: its C definition decides where its name disagrees.

    The published example calls `double` `DT_SInt64`: the code that is compiled is right, the name is not. But its
    `DT_Bool` held in an `unsigned char` is a boolean.
    """
    meant = c_type(c_definition) if c_definition else None
    promised = reference_type(reference)
    if reference in BY_REFERENCE and (meant is None or (promised is not None and agree(promised, meant))):
        return BY_VSS[BY_REFERENCE[reference].vss]
    return _BY_KIND.get((meant.kind, meant.bits)) if meant else None


def with_catalogue_elements(datatype: Datatype, vss_datatype: str | None, known: Mapping[str, Datatype]) -> Datatype:
    """An array of numbers as it is sent: its elements are those of the catalogue, whatever the code has."""
    sent = BY_VSS.get(element_of(vss_datatype or ""))
    element = known.get(datatype.element or "")
    if datatype.kind != "array" or sent is None or (element is not None and element.kind):
        return datatype
    if of_reference(datatype.element or "", element.c_definition if element else "") == sent:
        return datatype
    reference = f"{sent.reference}Array{'' if datatype.length is None else datatype.length}"
    return datatype.model_copy(update={"reference": reference, "element": sent.reference, "vss_datatype": vss_datatype})
