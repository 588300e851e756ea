"""A value between the catalogue and the code: where its numbers come from, and what becomes of them."""

from collections.abc import Mapping
from typing import NamedTuple

from sigcat.adapter.core.numbers import DOUBLE, Number, NumberType
from sigcat.function.document.text_filters import AnyText
from sigcat.function.function_json.conversion import IDENTITY, Linear


class Element(NamedTuple):
    """One number on its way from a source to a target: from what is received to a variable, or from a variable to what
    is sent."""

    source: NumberType
    target: NumberType
    conversion: Linear = IDENTITY
    """From the number in the source to that in the target."""
    names: Mapping[int, int] | None = None
    """Numbers of an enumeration in the source, and their numbers in the target."""
    coded: tuple[int, int] | None = None
    """Smallest and greatest number in the code, if the code may have an enumeration for it."""
    least: Number | None = None
    """Smallest number of the source within the range; None if there is none below it."""
    greatest: Number | None = None
    is_checked: bool = False
    """Whether there is a check of the range, so that NaN and infinities are outside of it."""
    arithmetic: NumberType = DOUBLE
    """Type in which it is converted: double, or float for a controller without doubles."""
    units: tuple[str, str] = ("", "")
    """Units of source and target; empty where there is none, or the code has another factor."""

    @property
    def is_enumeration(self) -> bool:
        """Whether the code may have an enumeration for it."""
        return self.coded is not None


class Leaf(NamedTuple):
    """A number, or an array of numbers, within a value. A struct has one for each member."""

    source: str
    """Position in the source, after its name: ``, `.x`, `[i]`, `[i].x`, `.x[i]`."""
    target: str
    length: int | None
    """Elements, where there is an `[i]`."""
    element: Element
    init: tuple[Number, ...]
    """Start value in the target, for each element."""
    default: tuple[Number, ...]
    """Replacement for NaN, and for a value after a time-out."""
    replacement: tuple[Number, ...] | None = None
    """Replacement for a value out of range; None: the value passes."""


class WireField(NamedTuple):
    """A member of a struct, as it is received or sent."""

    name: str
    c: str
    length: int | None
    comment: str
    unit: str = ""


class WireStruct(NamedTuple):
    """A struct, as it is received or sent."""

    name: str
    comment: AnyText
    fields: tuple[WireField, ...]


class WireType(NamedTuple):
    """Datatype in which a value is received or sent: that of the catalogue."""

    c: str
    """Type in C: of an array that of its elements."""
    length: int | None = None
    is_struct: bool = False
    symbols: tuple[tuple[str, int], ...] = ()
    """Names and numbers of an enumeration."""

    @property
    def is_plain(self) -> bool:
        """Whether it is one number."""
        return not self.is_struct and self.length is None

    @property
    def is_one_struct(self) -> bool:
        """Whether it is a struct, and no array of them: C passes its address."""
        return self.is_struct and self.length is None


class Value(NamedTuple):
    """A value between the catalogue and the code."""

    wire: WireType
    leaves: tuple[Leaf, ...]
    is_bare: bool
    """Whether the variable is one number and not an array or a struct."""

    @property
    def is_checked(self) -> bool:
        """Whether any part of it can be out of range."""
        return any(leaf.element.is_checked or leaf.element.names is not None for leaf in self.leaves)

    @property
    def is_replaced(self) -> bool:
        """Whether a value out of range is replaced."""
        return any(leaf.replacement is not None for leaf in self.leaves)
