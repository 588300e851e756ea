"""Values in the code: the numbers, enumerations and arrays that a variable or the members of its struct hold."""

from collections.abc import Iterator, Mapping
from itertools import islice
from typing import Any, NamedTuple

from sigcat.catalogue.model.datatypes import INTEGER_RANGES
from sigcat.function.c_project.c_types import vss_datatype
from sigcat.function.c_project.comments import Comments
from sigcat.function.c_project.declarations import Constant, CType, Declarations, Place
from sigcat.function.c_project.remarks import Remark, remark_of
from sigcat.limits import CODE_VALUES


class Value(NamedTuple):
    """A value that the code holds, with what its comment says."""

    expression: str
    """In C: `rtU.bus.speed`."""
    name: str
    datatype: str
    """Datatype of VSS; of an array, that of its elements; empty if VSS has none."""
    type_name: str
    """As it is written in C."""
    place: Place
    remark: Remark
    length: int = 0
    """Elements of an array."""
    bits: int = 0
    """Bits of a bit field that does not fill its datatype; 0 of any other variable."""
    constants: tuple[Constant, ...] = ()
    """Constants of an enumeration."""
    start: Any = None
    """Initial value."""
    is_const: bool = False
    defined_by: str = "function"
    c_type: str = ""
    """Type in C, with its qualifiers, of a variable that the adapter defines."""
    key: str = ""
    """Name in the functions that use it: of a member its key, of a variable its name."""
    problem: str = ""
    """Why it cannot be an interface, after «it»."""


class Code(NamedTuple):
    """Declarations of the code, and its comments."""

    declarations: Declarations
    comments: Mapping[str, Comments]

    def remark(self, place: Place, name: str) -> Remark:
        """Facts in the comment behind a name on its line, or else in the one above the line."""
        comments = self.comments.get(place.file)
        if comments is None:
            return Remark()
        return remark_of(comments.beside(place.line, name) or comments.above(place.line))

    def heading(self, place: Place) -> str:
        """The comment above a line or its group."""
        comments = self.comments.get(place.file)
        return comments.heading(place.line) if comments else ""


class _At(NamedTuple):
    """A place within a variable."""

    expression: str
    name: str
    type: CType
    place: Place
    start: Any
    key: str
    width: int | None = None
    is_const: bool = False


def values_of(
    expression: str, kind: CType, place: Place, code: Code, start: Any = None, name: str = "", key: str = ""
) -> Iterator[Value]:
    """The values of a variable, in the order of its members, to the last struct within a struct.

    Of more than a model may have, one more than that: an array may have as many structs as its author likes.
    """
    yield from islice(
        _values(_At(expression, name or expression, kind, place, start, key or expression), code, 0), CODE_VALUES + 1
    )


_DEEPEST = 12


def _values(at: _At, code: Code, depth: int) -> Iterator[Value]:
    record = code.declarations.records.get(at.type.key) if at.type.kind == "record" else None
    if record is not None and record.members and not record.is_union and depth < _DEEPEST:
        for number, member in enumerate(record.members):
            start = _part(at.start, member.name, number)
            expression = f"{at.expression}.{member.name}"
            is_const = at.is_const or member.is_const
            inner = _At(expression, member.name, member.type, member.place, start, member.key, member.width, is_const)
            yield from _values(inner, code, depth + 1)
    elif at.type.kind == "array" and at.type.of is not None and at.type.of.kind == "record" and depth < _DEEPEST:
        for number in range(at.type.length):
            inner = at._replace(
                expression=f"{at.expression}[{number}]", type=at.type.of, start=_part(at.start, "", number)
            )
            yield from _values(inner, code, depth + 1)
    else:
        yield _value(at, code)


def _part(start: Any, name: str, number: int) -> Any:
    if isinstance(start, dict):
        return start.get(name)
    return start[number] if isinstance(start, list) and number < len(start) else None


def _value(at: _At, code: Code) -> Value:
    is_array = at.type.kind == "array"
    element = at.type.of if is_array and at.type.of else at.type
    datatype = vss_datatype(element)
    bits = at.width if at.width and datatype in INTEGER_RANGES and element.kind == "number" else 0
    if at.width == 1:
        datatype, bits = "boolean", 0
    elif bits:  # the smallest one that holds it
        whole = max(8, 1 << (bits - 1).bit_length())
        datatype, bits = f"{datatype.rstrip('0123456789')}{whole}", bits % whole
    return Value(
        expression=at.expression,
        name=at.name,
        datatype=datatype,
        type_name=element.name,
        place=at.place,
        remark=code.remark(at.place, at.name),
        length=at.type.length if is_array else 0,
        bits=bits,
        constants=code.declarations.enumerations.get(element.key, ()) if element.kind == "enumeration" else (),
        start=at.start,
        key=at.key,
        is_const=at.is_const,
        problem=_problem(element, datatype, code),
    )


_KINDS: Mapping[str, str] = {
    "pointer": "is a pointer",
    "array": "is an array of arrays",
    "void": "has no type",
    "other": "has a type that VSS does not have",
}


def _problem(element: CType, datatype: str, code: Code) -> str:
    if datatype:
        return ""
    if element.kind == "record":
        record = code.declarations.records.get(element.key)
        return "is a union" if record and record.is_union else "is a struct whose members are not in the folder"
    return _KINDS.get(element.kind, f"has the type {element.name}, which VSS does not have")
