"""Datatypes: what the code has (implementation), what it means (application), and how one becomes the other."""

from typing import Literal

from sigcat.function.document.field_types import CIdentifier, NumberText, ShortName, UnitKey
from sigcat.function.document.text import Text
from sigcat.function.function_json.wire import Integer, Listed, Number, WireModel, always, own


class Symbol(WireModel):
    """A named value of an enumeration."""

    symbol: ShortName = always("Symbol", "Name of the value.")
    value: Integer = always("Value", "Its number.")


class Unit(WireModel):
    """A unit."""

    name: ShortName = always("Name", "Short name of the unit.")
    display_name: UnitKey = always("DisplayName", "Unit as the catalogue has it: km/h.")


class CompuMethod(WireModel):
    """Meaning of the numbers of a datatype. Values travel in the unit of the catalogue: no number is scaled."""

    name: ShortName = always("Name", "Name of the method.")
    category: Literal["IDENTICAL", "LINEAR", "TEXTTABLE"] = always(
        "Category", "IDENTICAL: the number itself; LINEAR: scaled; TEXTTABLE: an enumeration."
    )
    unit: ShortName | None = own("Unit", "Name of the unit.")
    factor: NumberText | None = own(
        "Factor", "Value = number × factor + offset; exact: a decimal number or a fraction."
    )
    offset: NumberText | None = own("Offset", "Offset of that.")
    symbols: Listed[Symbol] | None = own("Symbols", "Values of an enumeration.")


class DataConstraint(WireModel):
    """The range of a datatype."""

    name: ShortName = always("Name", "Name of the constraint.")
    min: Number | None = own("Min", "Smallest value, in the unit of the datatype.")
    max: Number | None = own("Max", "Largest value.")


class TypeMember(WireModel):
    """A member of a structure."""

    name: ShortName = always("Name", "Name of the member.")
    type: ShortName = always(
        "Type", "Name of its datatype: an implementation type in one of these, an application type else."
    )
    description: Text | None = own("Description", "What the member means.")


class ImplementationType(WireModel):
    """A datatype of the code, as the RTE generates it into Rte_Type.h."""

    name: ShortName = always("Name", "Name of the datatype, which is its name in C.")
    category: Literal["VALUE", "TYPE_REFERENCE", "ARRAY", "STRUCTURE"] = always(
        "Category",
        "VALUE: a platform type, which the vendor has; TYPE_REFERENCE: another name for one; ARRAY, STRUCTURE.",
    )
    base: ShortName | None = own(
        "Base", "Platform type of a value (uint8, sint16, float32, boolean, ...), or the one that is referred to."
    )
    element: ShortName | None = own("ElementType", "Implementation type of the elements of an array.")
    length: Integer | None = own("Length", "Elements of an array.")
    members: Listed[TypeMember] | None = own("Members", "Members of a structure, in order.")
    compu_method: ShortName | None = own("CompuMethod", "Name of the method of an enumeration.")
    literal_prefix: CIdentifier | None = own(
        "LiteralPrefix", "What the names of its values begin with in C, where two enumerations may have one name."
    )
    reference: ShortName | None = own("TypeRef", "Reference in Function JSON.")


class ApplicationType(WireModel):
    """Meaning of the values of a data element: unit, range, names."""

    name: ShortName = always("Name", "Name of the datatype.")
    category: Literal["VALUE", "BOOLEAN", "ARRAY", "STRUCTURE"] = always(
        "Category", "VALUE, BOOLEAN, ARRAY or STRUCTURE."
    )
    implementation: ShortName = always("ImplementationType", "Name of the datatype of the code that it is mapped to.")
    compu_method: ShortName | None = own("CompuMethod", "Name of the method; absent for arrays and structures.")
    constraint: ShortName | None = own("DataConstraint", "Name of the range.")
    unit: ShortName | None = own("Unit", "Name of the unit.")
    element: ShortName | None = own("ElementType", "Application type of the elements of an array.")
    length: Integer | None = own("Length", "Elements of an array.")
    members: Listed[TypeMember] | None = own("Members", "Members of a structure, in order.")
    description: Text | None = own("Description", "What the values mean.")


class ModeNumber(WireModel):
    """A mode of a group."""

    name: ShortName = always("Name", "Name of the mode.")
    value: Integer = always("Value", "Number of the mode, which the core takes and gives.")


class ModeGroup(WireModel):
    """A mode declaration group: the modes of an interface."""

    name: ShortName = always("Name", "Name of the group.")
    modes: Listed[ModeNumber] = always("Modes", "Modes, in the order of the declaration.")
    initial: ShortName = always("InitialMode", "Mode in which the mode machine starts.")
    type: ShortName = always("Type", "Implementation type that holds a mode.")
    on_transition: Integer = always("OnTransitionValue", "Number that Rte_Mode returns during a transition.")
