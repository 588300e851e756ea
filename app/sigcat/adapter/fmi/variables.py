"""Variables of an FMU, and where their values are among the bytes of an instance.

A value of the core is one variable if it is a number or an array of numbers. A struct has a variable for each member.
"""

import math
import re
import struct
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.core.plan import Value
from sigcat.adapter.core.plan.value import Element, WireStruct
from sigcat.adapter.host.connections import Connections, Entry, Exit, Member, shape_of, structs_of
from sigcat.adapter.host.shapes import Array, Number, Shape, packing
from sigcat.catalogue.model.datatypes import INTEGER_RANGES
from sigcat.function.document.field_types import FMI_VARIABLE
from sigcat.function.function_json.conversion import IDENTITY
from sigcat.function.function_json.walk import parameters
from sigcat.integration.fmi.model import Causality, FmiType

_INDEX = re.compile(r"\[[0-9]+\]")
Start = tuple[int | float | bool, ...]
_TYPES: Mapping[str, FmiType] = {
    "float": "Float32", "double": "Float64", "int8": "Int8", "uint8": "UInt8", "int16": "Int16", "uint16": "UInt16",
    "int32": "Int32", "uint32": "UInt32", "int64": "Int64", "uint64": "UInt64", "boolean": "Boolean",
}  # fmt: skip


class Variable(NamedTuple):
    """A variable; its value reference is its index among all of them."""

    name: str
    causality: Causality
    number: Number
    length: int | None
    """Elements of an array."""
    owner: int
    """Number of the entry or the exit, or the function whose parameter it is."""
    offset: int
    """Offset of its first byte among the values of an instance."""
    start: Start
    unit: str = ""
    least: int | float | None = None
    greatest: int | float | None = None
    description: str = ""

    @property
    def type(self) -> FmiType:
        """Datatype of FMI."""
        return "Enumeration" if self.number.symbols else _TYPES[self.number.datatype]

    @property
    def storage(self) -> str:
        """Datatype in which it is stored, as the constants of `sigcat_fmu.h` end."""
        return _TYPES[self.number.datatype].upper()


class Layout(NamedTuple):
    """The variables of an FMU, and the places of its values."""

    variables: tuple[Variable, ...]
    inputs: tuple["Input", ...]
    """For each entry."""
    outputs: tuple[int, ...]
    """Offset of the value of each exit."""
    parameters: tuple[int, ...]
    """Offset of the parameters of each function."""
    values: bytes
    """All values in the beginning."""


class Input(NamedTuple):
    """Something that a function receives."""

    offset: int
    """Offset of its value; 0 where another function of the FMU sends it."""
    variable: int
    """The first entry of its name: all of them are one variable."""


class _Place(NamedTuple):
    """A value of a core, and its place."""

    name: str
    shape: Shape
    causality: Causality
    owner: int
    offset: int
    unit: str
    description: str
    value: Value | None
    """Its plan, for its range and its start value; None for a status."""
    start: int = 0
    units: Mapping[str, str] = {}
    """Units of the members of a struct, by their names after that of the value: `.Start.X`."""


def layout_of(connections: Connections, *, has_arrays: bool = True) -> Layout:
    """The variables of a set of functions. What one function sends to another one is an output alone.

    Without arrays, each element of one is a variable.
    """
    places, outputs, parameters = _Places(), list[int](), list[int]()
    inputs: list[Input] = []
    first: dict[str, int] = {}
    inside = {target for route in connections.routes for target in route} | connections.servers.keys()
    for index, entry in enumerate(connections.entries):
        known = first.setdefault(entry.names[-1], index)
        if index in inside:
            inputs.append(Input(0, index))
        elif known != index:
            inputs.append(inputs[known])
        else:
            inputs.append(Input(places.add(_of_entry(index, entry, connections)), index))
    for index, each in enumerate(connections.exits):
        outputs.append(places.add(_of_exit(index, each, connections)))
    for index in range(len(connections.members)):
        parameters.append(places.size)
        for place in _of_parameters(index, connections):
            places.add(place)
    variables = tuple(_variables(places.found, has_arrays=has_arrays))
    return Layout((_TIME, *variables), tuple(inputs), tuple(outputs), tuple(parameters), _bytes(variables, places.size))


def _bytes(variables: Iterable[Variable], size: int) -> bytes:
    """Start values, each at its place."""
    values = bytearray(size)
    for each in variables:
        code = packing(each.number).struct.format.lstrip("=")
        struct.pack_into(f"={len(each.start)}{code}", values, each.offset, *each.start)
    return bytes(values)


_TIME = Variable("time", "independent", Number("double"), None, 0, 0, (), "s", description="Time of the simulation.")


class _Places:
    """Values one after the other."""

    def __init__(self) -> None:
        self.found: list[_Place] = []
        self.size = 0

    def add(self, place: _Place) -> int:
        """Give a value the next place, and return its offset."""
        offset, self.size = self.size, self.size + packing(place.shape).struct.size
        self.found.append(place._replace(offset=offset))
        return offset


def _of_entry(index: int, entry: Entry, connections: Connections) -> _Place:
    plan = connections.members[entry.member].plan
    port = next((each for each in plan.ports if each.name == entry.receiver), None)
    value = port.consumers[0][1].value if port and not entry.is_answer else None
    description = port.comment if port else f"{entry.receiver}, which {plan.function} receives"
    if entry.is_answer:
        description = f"Answer to {entry.receiver}, which {plan.function} asks for"
    units = _units(value, connections.members[entry.member])
    return _Place(entry.names[-1], entry.shape, "input", index, 0, entry.unit, description, value, units=units)


def _of_exit(index: int, each: Exit, connections: Connections) -> _Place:
    plan = connections.members[each.member].plan
    output = next((one for one in plan.outputs if one.named.name == each.field), None)
    start = {error.named.name: error.passed for error in plan.errors}.get(each.field, 0)
    description = output.named.comment if output else f"{each.field} of {plan.function}"
    value = output.value if output else None
    units = _units(value, connections.members[each.member])
    return _Place(each.names[-1], each.shape, "output", index, 0, each.unit, description, value, start, units)


def _of_parameters(index: int, connections: Connections) -> Iterator[_Place]:
    member = connections.members[index]
    structs = structs_of(member)
    declared = {pointer: item for pointer, _, item in parameters(member.function.function)}
    for each in member.plan.settable:
        item = declared[each.named.pointer]
        shape = shape_of(each.value.wire, structs)
        name, unit = item.vss_path or item.name, item.vss_unit or ""
        units = _units(each.value, member)
        yield _Place(name, shape, "parameter", index, 0, unit, each.named.comment, each.value, units=units)


def _units(value: Value | None, member: Member) -> Mapping[str, str]:
    if value is None or not value.wire.is_struct:
        return {}
    structs = {each.name: each for each in member.plan.structs}
    return dict(_units_of(value.wire.c, "", structs))


def _units_of(struct: str, before: str, structs: Mapping[str, WireStruct]) -> Iterator[tuple[str, str]]:
    for field in structs[struct].fields:
        name = f"{before}.{field.name}"
        if field.c in structs:
            yield from _units_of(field.c, name, structs)
        else:
            yield name, field.unit


# -- leaves -------------------------------------------------------------------------------------------------------


def _variables(places: Sequence[_Place], *, has_arrays: bool) -> Iterator[Variable]:
    taken: set[str] = {_TIME.name}
    for place in sorted(
        places, key=lambda each: each.causality != "output"
    ):  # an output has the name that it has everywhere
        name = free_name(place.name, place.causality, taken)
        leaves = list(_leaves(name, place.shape, place.offset))
        for leaf in leaves if has_arrays else _elements(leaves):
            taken.add(leaf.name)
            made = _variable(leaf, place, is_whole=leaf.name.partition("[")[0] == name)
            member = _INDEX.sub("", leaf.name.removeprefix(name))
            yield made._replace(unit=place.units[member]) if member in place.units else made


class _Leaf(NamedTuple):
    name: str
    number: Number
    length: int | None
    offset: int
    element: int = 0
    """Index in the array, if it is an element of one."""


def _leaves(name: str, shape: Shape, offset: int) -> Iterator[_Leaf]:
    if isinstance(shape, Number):
        yield _Leaf(name, shape, None, offset)
    elif isinstance(shape, Array) and isinstance(shape.element, Number):
        yield _Leaf(name, shape.element, shape.length, offset)
    elif isinstance(shape, Array):
        size = packing(shape.element).struct.size
        for index in range(shape.length):
            yield from _leaves(f"{name}[{index + 1}]", shape.element, offset + index * size)
    else:
        for field, inner in shape.fields:
            yield from _leaves(f"{name}.{field}", inner, offset)
            offset += packing(inner).struct.size


def _elements(leaves: Iterable[_Leaf]) -> Iterator[_Leaf]:
    """Numbers, each of an array by its index from 1."""
    for leaf in leaves:
        size = packing(leaf.number).struct.size
        if leaf.length is None:
            yield leaf
        for index in range(leaf.length or 0):
            yield _Leaf(f"{leaf.name}[{index + 1}]", leaf.number, None, leaf.offset + index * size, index)


def _variable(leaf: _Leaf, place: _Place, *, is_whole: bool) -> Variable:
    element = place.value.leaves[0].element if place.value and is_whole and len(place.value.leaves) == 1 else None
    is_input = place.causality != "output"
    least = element.least if element and is_input else None
    greatest = element.greatest if element and is_input else None
    return Variable(
        leaf.name, place.causality, leaf.number, leaf.length, place.owner, leaf.offset,
        _start(leaf, place, least, greatest), place.unit, _limit_of_model(least, leaf.number), _limit_of_model(greatest, leaf.number),
        place.description,
    )  # fmt: skip


def _start(leaf: _Leaf, place: _Place, least: object, greatest: object) -> Start:
    """Start values in the catalogue's unit; of a struct and of a status zeros, or what is nearest to them within the range."""
    count = leaf.length or 1
    if place.value is not None and len(place.value.leaves) == 1:
        start = place.value.leaves[0]
        given = start.init if place.causality == "output" else [_received(each, start.element) for each in start.init]
        whole = tuple(given) * count if len(given) == 1 else tuple(given)[leaf.element : leaf.element + count]
        return tuple(_typed(each, leaf.number) for each in whole)
    number: int | float = place.start
    if leaf.number.symbols and number not in {value for _, value in leaf.number.symbols}:
        number = leaf.number.symbols[0][1]
    if isinstance(least, int | float) and number < least:
        number = least
    if isinstance(greatest, int | float) and number > greatest:
        number = greatest
    return (_typed(number, leaf.number),) * count


def _received(number: float, element: Element) -> float:
    """Return the number that is received for one of the code."""
    if element.names is not None:
        return next((source for source, target in element.names.items() if target == number), number)
    if element.conversion == IDENTITY or not math.isfinite(number):
        return number
    exact = element.conversion.inverse(number)
    return int(exact) if exact.denominator == 1 else float(exact)


def _typed(number: float, datatype: Number) -> int | float | bool:
    if datatype.datatype == "boolean":
        return bool(number)
    if not math.isfinite(number):
        return _typed(0, datatype)  # a model description has no such start value
    if datatype.is_whole:
        low, high = INTEGER_RANGES[datatype.datatype]
        return int(min(max(number, low), high))
    return struct.unpack("=f", struct.pack("=f", number))[0] if datatype.datatype == "float" else float(number)


def _limit_of_model(limit: float | None, datatype: Number) -> int | float | None:
    """A limit as modelDescription.xml may have it: not of a truth value, and not of an enumeration, which has its items."""
    return None if limit is None or datatype.symbols or datatype.datatype == "boolean" else _typed(limit, datatype)


def _structured(name: str) -> str:
    """A name of the structured form of FMI; in quotation marks if it is not of that form."""
    if FMI_VARIABLE.accepts(name):
        return name
    return "".join(("'", re.sub(r"[^A-Za-z0-9_ .:,/-]", "_", name), "'"))


def free_name(name: str, role: str, taken: Iterable[str]) -> str:
    """The name in the structured form that no other variable has: what is received beside what is sent, as the state of a safety reaction."""
    name, known = _structured(name), set(taken)
    if name not in known:
        return name
    longer = f"{name}.{'received' if role == 'input' else role}"
    return next(each for each in (longer, *(f"{longer}{n}" for n in range(2, 1000))) if each not in known)
