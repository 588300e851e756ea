"""Connections of a set: received and sent values, joined by path, else by the name of the interface."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat import codes
from sigcat.adapter.core.core_values import struct_name
from sigcat.adapter.core.identifiers import identifier
from sigcat.adapter.core.numbers import type_of_c
from sigcat.adapter.core.plan import Argument, CorePlan, Method, WireField, WireStruct, WireType
from sigcat.adapter.core.planning import Context, context_of
from sigcat.adapter.host.host_plan import Kind, received_values, sent_values
from sigcat.adapter.host.ranges import Range, range_of
from sigcat.adapter.host.shapes import Array, Number, Record, Shape
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.function.document.document import Pointer
from sigcat.function.exchange import Side, exchange_of, parts_of
from sigcat.function.function_json.datatypes.datatype import innermost
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.resolved_function import ResolvedFunction

Symbols = tuple[tuple[str, int], ...]
"""Names and numbers of an enumeration."""


class Member(NamedTuple):
    """A function of the set."""

    function: ResolvedFunction
    plan: CorePlan
    folder: Path
    """Folder at which the paths of its code begin."""

    @property
    def name(self) -> str:
        """Beginning of all names of its adapter."""
        return self.plan.function


class Entry(NamedTuple):
    """Something that a function receives."""

    member: int
    """Index of the function in the set."""
    receiver: str
    """The end of the name of the function in C that takes it: `EgoSpd` of `…_Receive_EgoSpd`."""
    names: tuple[str, ...]
    """Its names: the path, the name, or both."""
    wire: WireType
    shape: Shape
    pointer: Pointer | None
    unit: str = ""
    range: Range | None = None
    kind: Kind = "signal"
    good: int | None = None
    """Number that says that all is well."""
    is_answer: bool = False
    """Whether it is what is answered from then on to a method that the function uses: its results, or whether it is good."""


class Exit(NamedTuple):
    """Something that a function sends."""

    member: int
    field: str
    """Its name in `out` and `publish`."""
    names: tuple[str, ...]
    """Its names; the first one is that of its column."""
    wire: WireType
    shape: Shape
    unit: str = ""
    is_queue: bool = False
    kind: Kind = "signal"
    good: int | None = None
    """Number that says that all is well."""

    @property
    def is_shared(self) -> bool:
        """Whether others receive it. A safety reaction is decided by each function for itself, from the same errors."""
        return self.kind != "safety reaction"

    @property
    def name(self) -> str:
        """Name in recordings."""
        return self.names[0]


class Server(NamedTuple):
    """Function of the set that answers the requests of a method that another one uses."""

    member: int
    method: int
    """Its index among the methods of that function."""


class Connections(NamedTuple):
    """A set of functions, connected."""

    members: tuple[Member, ...]
    entries: tuple[Entry, ...]
    exits: tuple[Exit, ...]
    routes: tuple[tuple[int, ...], ...]
    """For each exit the entries that get what it sends."""
    servers: Mapping[int, Server]
    """For entries of answers who gives them, where that is a function of the set."""

    @property
    def received(self) -> Mapping[str, Shape]:
        """Values from outside, by each of their names."""
        return {name: entry.shape for entry in self._outside for name in entry.names}

    @property
    def first_names(self) -> Mapping[str, str]:
        """The first name of each value from outside, by each of its names."""
        return {name: entry.names[0] for entry in self._outside for name in entry.names}

    @property
    def ranges(self) -> Mapping[str, Range]:
        """Ranges of the catalogue, by every name of a value from outside that has one."""
        return {name: entry.range for entry in self._outside for name in entry.names if entry.range is not None}

    @property
    def inputs(self) -> tuple[tuple[str, ...], ...]:
        """The names of each signal and mode that is received from outside."""
        return tuple(each.names for each in self._outside if each.kind in ("signal", "mode") and not each.is_answer)

    @property
    def _outside(self) -> Iterator[Entry]:
        inside = {target for route in self.routes for target in route} | self.servers.keys()
        return (entry for index, entry in enumerate(self.entries) if index not in inside)

    @property
    def units(self) -> Mapping[str, str]:
        """Units of the catalogue, by every name of a value that has one."""
        ends = [(each.names, each.unit) for each in self.entries] + [(each.names, each.unit) for each in self.exits]
        return {name: unit for names, unit in ends for name in names if unit}


def connect(members: Sequence[Member]) -> Connections:
    """The connections of functions. Raises InputRefused if both ends of one do not hold the same values."""
    entries = tuple(entry for index, member in enumerate(members) for entry in _entries(index, member))
    exits = tuple(each for index, member in enumerate(members) for each in _exits(index, member))
    routes = tuple(_routes(exits, entries))
    servers = dict(_servers(members, entries))
    findings = (*_mismatches(members, entries, exits, routes), *_unlike_methods(members, entries, servers))
    if findings:
        raise InputRefused("The functions cannot be connected.", findings)
    return Connections(tuple(members), entries, exits, routes, servers)


def _servers(members: Sequence[Member], entries: Sequence[Entry]) -> Iterator[tuple[int, Server]]:
    """The function that offers what another one uses, by the index of the entry of the answer."""
    exchange = exchange_of(parts_of(member.function.function for member in members))
    indexes = {member.function.name: index for index, member in enumerate(members)}
    for number, entry in enumerate(entries):
        provider = exchange.elements["method", entry.names[0]].provider if entry.is_answer else None
        if provider is not None and (index := indexes[provider.function]) != entry.member:
            pointers = [method.named.pointer for method in members[index].plan.methods]
            yield number, Server(index, pointers.index(provider.pointer))


def _unlike_methods(
    members: Sequence[Member], entries: Sequence[Entry], servers: Mapping[int, Server]
) -> Iterator[Finding]:
    """Methods whose two sides do not take and give the same."""
    for index, server in servers.items():
        entry, member, other = entries[index], members[entries[index].member], members[server.member]
        used = next(each for each in member.plan.methods if each.named.name == entry.receiver)
        offered = other.plan.methods[server.method]
        if any(_shapes(one, member) != _shapes(two, other)
               for one, two in ((used.arguments, offered.arguments), (used.results, offered.results))):  # fmt: skip
            message = f"{entry.names[0]} must have the arguments and results that it has in {other.name}."
            fix = "Make them equal in both functions."
            yield member.function.finding(codes.PROVIDED_AS_ANOTHER_DATATYPE, entry.pointer or (), message, fix)


def _shapes(listed: Sequence[Argument], member: Member) -> list[Shape]:
    structs = structs_of(member)
    return [shape_of(each.value.wire, structs) for each in listed]


def handed_over(member: Member) -> Iterator[Shape]:
    """The arguments, and the results, of each method of a function."""
    structs = structs_of(member)
    for method in member.plan.methods:
        for listed in (method.arguments, method.results):
            yield Record(tuple((each.name, shape_of(each.value.wire, structs)) for each in listed))


def _routes(exits: Iterable[Exit], entries: Sequence[Entry]) -> Iterator[tuple[int, ...]]:
    """For each exit the entries that have one of its names."""
    named: dict[str, list[int]] = {}
    for index, entry in enumerate(entries):
        for name in entry.names:
            named.setdefault(name, []).append(index)
    for each in exits:
        yield tuple(sorted({index for name in each.names if each.is_shared for index in named.get(name, ())}))


def _mismatches(
    members: Sequence[Member], entries: Sequence[Entry], exits: Sequence[Exit], routes: Sequence[Sequence[int]]
) -> Iterator[Finding]:
    """Ends that do not hold the same: an exit and what it feeds, and entries of one name."""
    leading: dict[str, tuple[int, Shape]] = {}
    for each, route in zip(exits, routes, strict=True):
        leading.update((name, (each.member, each.shape)) for target in route for name in entries[target].names)
    for entry in entries:
        for name in entry.names:
            index, shape = leading.setdefault(name, (entry.member, entry.shape))
            if not _fit(shape, entry.shape):
                other, member = members[index].name, members[entry.member]
                message = f"{name} must have the datatype and length that it has in {other}."
                fix = "Make them equal in both functions."
                yield member.function.finding(codes.PROVIDED_AS_ANOTHER_DATATYPE, entry.pointer or (), message, fix)
                break


# -- of one function ----------------------------------------------------------------------------------------------


def _entries(index: int, member: Member) -> Iterator[Entry]:
    sides, structs = sides_of(member.function.function), structs_of(member)
    for each in received_values(member.plan):
        at, shape = each.pointer, shape_of(each.wire, structs)
        names = sides[at].names if at else (each.name,)
        unit, held = "", None
        if at and each.kind == "signal":
            data = sides[at].data
            unit, held = data.vss_unit or "", range_of(data.vss_min, data.vss_max, shape)
        yield Entry(
            index, each.name, names, each.wire, shape, at, unit, held, each.kind, next(iter(each.numbers), None)
        )
    yield from _answers(index, member)


def answer_struct(method: Method, plan: CorePlan) -> WireStruct:
    """The results of a method, as the adapter takes or gives them."""
    return _struct(f"{plan.type_name}_{method.named.name}_Results", method.results)


def request_struct(method: Method, plan: CorePlan) -> WireStruct:
    """The arguments of a method, as the adapter gives or takes them."""
    return _struct(f"{plan.type_name}_{method.named.name}_Arguments", method.arguments)


def _struct(name: str, listed: Sequence[Argument]) -> WireStruct:
    fields = (WireField(each.name, each.value.wire.c, each.value.wire.length, "") for each in listed)
    return WireStruct(name, "", tuple(fields))


def _answers(index: int, member: Member) -> Iterator[Entry]:
    sides, structs = sides_of(member.function.function), structs_of(member)
    for method in member.plan.methods:
        if method.is_offered:
            continue
        fields = tuple((each.name, shape_of(each.value.wire, structs)) for each in method.results)
        struct = answer_struct(method, member.plan).name
        wire = WireType(struct, is_struct=True) if fields else WireType("bool")
        shape: Shape = Record(fields) if fields else Number("boolean")
        at, name = method.named.pointer, method.named.name
        yield Entry(index, name, sides[at].names, wire, shape, at, is_answer=True)


def _exits(index: int, member: Member) -> Iterator[Exit]:
    sides, structs = sides_of(member.function.function), structs_of(member)
    for each in sent_values(member.plan):
        side, shape = sides[each.pointer or ()], shape_of(each.wire, structs)
        unit = side.data.vss_unit or "" if each.kind == "signal" else ""
        good = next(iter(each.numbers), None)
        yield Exit(index, each.name, side.names, each.wire, shape, unit, each.is_queue, each.kind, good)


def sides_of(function: FunctionJson) -> Mapping[Pointer, Side]:
    """Sides of a function in the exchange, by pointer."""
    sides = exchange_of(parts_of((function,))).sides
    return {side.pointer: side for side in reversed(sides)}  # the first at a pointer is that of its own interface


# -- shapes -------------------------------------------------------------------------------------------------------


class Structs(NamedTuple):
    """The structs of a function, and the symbols of their members that are enumerations."""

    known: Mapping[str, WireStruct]
    symbols: Mapping[tuple[str, str], Symbols]


def structs_of(member: Member) -> Structs:
    """The structs of a function, by their names in C."""
    context = context_of(member.function.function)
    symbols = {
        (struct_name(datatype.reference, context), identifier(field.name)): _symbols(field.datatype, context)
        for datatype in context.datatypes.values() if datatype.kind == "struct"
        for field in datatype.fields or ()
    }  # fmt: skip
    return Structs({struct.name: struct for struct in member.plan.structs}, symbols)


def _symbols(reference: str, context: Context) -> Symbols:
    datatype = innermost(reference, context.datatypes)
    return tuple((each.symbol, each.value) for each in (datatype.symbols if datatype else None) or ())


def shape_of(wire: WireType, structs: Structs | None = None) -> Shape:
    """Return the shape of a received or sent value."""
    inner = _record(wire.c, structs) if wire.is_struct and structs else _number(wire.c, wire.symbols)
    return inner if wire.length is None else Array(inner, wire.length)


def _record(name: str, structs: Structs) -> Record:
    return Record(tuple((field.name, _field(name, field, structs)) for field in structs.known[name].fields))


def _field(struct: str, field: WireField, structs: Structs) -> Shape:
    symbols = structs.symbols.get((struct, field.name), ())
    inner = _record(field.c, structs) if field.c in structs.known else _number(field.c, symbols)
    return inner if field.length is None else Array(inner, field.length)


def _number(c: str, symbols: Symbols) -> Number:
    found = type_of_c(c)
    assert found is not None, c
    return Number(found.name, tuple(symbols))


def _fit(one: Shape, other: Shape) -> bool:
    """Whether values of one are values of the other: symbols that both have mean the same numbers."""
    if isinstance(one, Number) and isinstance(other, Number):
        numbers = {symbol.upper(): number for symbol, number in one.symbols}
        same = all(numbers.get(symbol.upper(), number) == number for symbol, number in other.symbols)
        return one.datatype == other.datatype and same
    if isinstance(one, Array) and isinstance(other, Array):
        return one.length == other.length and _fit(one.element, other.element)
    return one == other
