"""Conversions between messages and the core: of fields, of arguments, and of structs member by member."""

from collections.abc import Iterable, Sequence
from typing import NamedTuple

from sigcat.adapter.core.plan import WireType
from sigcat.adapter.ros2.plan import ArgumentField, NodePlan, ReceivedField, SentField, StructPair
from sigcat.function.document.text_filters import python_string
from sigcat.names import snake_case


class Conversion(NamedTuple):
    """A conversion of a value of a message for the core, or back; without a function and a table, the value stays as it is."""

    function: str = ""
    table: Sequence[tuple[str, str]] = ()
    """Literals of values on both sides."""
    other: str | None = None
    """Literal for all values that are not in the table; None for the value itself."""
    is_each: bool = False
    """Whether the elements are converted, and not the whole."""


_UNCHANGED = Conversion()


class Field(NamedTuple):
    """A field of a message, its name in the core, and conversions for the core and for the message."""

    name: str
    core: str
    for_core: Conversion
    for_message: Conversion


def for_core(taken: ReceivedField, node: NodePlan) -> Conversion:
    """The conversion of a field of a message."""
    is_each = taken.wire.length is not None
    if taken.symbols:
        pairs = [(python_string(each.text), str(each.number)) for each in taken.symbols]
        return Conversion("", pairs, str(taken.nameless), is_each)
    if taken.numbers:
        return Conversion("", [(str(one), str(other)) for one, other in taken.numbers], None, is_each)
    return _wire_for_core(taken.wire, node) if taken.wire.is_struct else _UNCHANGED


def for_message(given: SentField, node: NodePlan) -> Conversion:
    """The conversion of a value of the core."""
    is_each = given.wire.length is not None
    if given.symbols:
        pairs = [(str(each.number), python_string(each.text)) for each in given.symbols]
        return Conversion("", pairs, python_string(""), is_each)
    if given.numbers:
        return Conversion("", [(str(one), str(other)) for one, other in given.numbers], None, is_each)
    return _wire_for_message(given.wire, node)


def struct_fields(pair: StructPair, node: NodePlan) -> Sequence[Field]:
    """Members of a struct that a message and the core have."""
    structs = {each.struct.name for each in node.structs}
    return [
        _field(name, member.name, WireType(member.c, member.length, is_struct=member.c in structs), node)
        for name, member in zip(pair.members, pair.struct.fields, strict=True)
    ]


def struct_stem(pair: StructPair) -> str:
    """Beginning of the names of functions that convert a struct."""
    return snake_case(pair.message.name)


def _field(name: str, core: str, wire: WireType, node: NodePlan) -> Field:
    return Field(name, core, _wire_for_core(wire, node), _wire_for_message(wire, node))


def _stem_of(wire: WireType, node: NodePlan) -> str:
    return next(struct_stem(pair) for pair in node.structs if pair.struct.name == wire.c)


def _wire_for_core(wire: WireType, node: NodePlan) -> Conversion:
    """The conversion of a field, by its type alone: the core takes lists."""
    if wire.is_struct:
        return Conversion(f"_{_stem_of(wire, node)}_of", is_each=wire.length is not None)
    return _UNCHANGED if wire.length is None else Conversion("list")


def _wire_for_message(wire: WireType, node: NodePlan) -> Conversion:
    """The conversion of a value of the core, by its type alone."""
    if wire.is_struct:
        return Conversion(f"_{_stem_of(wire, node)}_message", is_each=wire.length is not None)
    return _UNCHANGED


def argument_fields(fields: Iterable[ArgumentField], node: NodePlan) -> Sequence[Field]:
    """Fields of a request or a response."""
    return [_field(each.field, each.argument.name, each.argument.value.wire, node) for each in fields]
