"""A set of functions: what fits in each of them, and not together."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fractions import Fraction
from typing import NamedTuple

from app.catalogue.model import Catalogue
from app.findings import Finding, in_order
from app.function.asil import level_of, rank
from app.function.build import is_function_json, place_in, resolved
from app.function.datatypes import c_type
from app.function.declaration import Declared, read_declaration
from app.function.defining import layered
from app.function.document import Document, Place, Pointer, pointer_text, read_json
from app.function.model import CONSUMER, PROVIDER, DataQueue, Datatype, FunctionJson, Runnable, Signal, milliseconds
from app.function.order import contradiction, previous_calls
from app.function.severities import SEVERITIES
from app.function.validate import validated
from app.function.walk import data, errors, runnables
from app.names import did_you_mean

Datum = Signal | DataQueue


class Member(NamedTuple):
    """A function of the set, and the file that it stands in."""

    file: str
    digest: str
    is_declaration: bool
    function: FunctionJson | None
    """None if the structure of the file is wrong; incomplete if there are errors."""
    findings: tuple[Finding, ...]
    locate: Callable[[Pointer], tuple[Place, Pointer]]
    """Where in the file a part of the Function JSON comes from."""


def check_functions(
    files: Sequence[tuple[bytes, str]], catalogue: Catalogue, *, is_whole: bool = True
) -> tuple[Finding, ...]:
    """Everything that is wrong with function files, alone and together. What one defines, the others may use.

    `is_whole`: there are no further functions, so that what nobody here provides, nobody provides.
    """
    members, over = read_set(files, catalogue)
    alone = [finding for member in members for finding in member.findings]
    return in_order([*alone, *check_set(members, over, is_whole=is_whole)])


def read_set(files: Sequence[tuple[bytes, str]], catalogue: Catalogue) -> tuple[tuple[Member, ...], Catalogue]:
    """The functions of files, and the catalogue with everything that they define."""
    read = [
        (data, name, None if is_function_json(data, name) else read_declaration(data, name)) for data, name in files
    ]
    over = catalogue
    for _, _, declared in read:
        if declared is not None and declared.declaration is not None:
            over = layered(declared.declaration, declared.document, over)
    return tuple(
        _of_json(read_json(data, name), over) if declared is None else _of_declaration(declared, over)
        for data, name, declared in read
    ), over


def _of_json(document: Document, catalogue: Catalogue) -> Member:
    made = validated(document, catalogue)

    def locate(pointer: Pointer) -> tuple[Place, Pointer]:
        return document.place(pointer), pointer

    return Member(document.name, document.digest, False, made.function, made.findings, locate)


def _of_declaration(declared: Declared, catalogue: Catalogue) -> Member:
    document = declared.document
    if declared.declaration is None:
        findings = in_order(declared.findings)
        return Member(document.name, document.digest, True, None, findings, lambda _: ((0, 0), ()))
    work, function = resolved(declared, declared.declaration, catalogue)

    def locate(pointer: Pointer) -> tuple[Place, Pointer]:
        at = place_in(pointer, work)
        return document.place(at), at

    findings = in_order([*declared.findings, *work.findings])
    return Member(document.name, document.digest, True, function, findings, locate)


def check_set(
    members: Sequence[Member], catalogue: Catalogue | None = None, *, is_whole: bool = True
) -> tuple[Finding, ...]:
    """What does not fit together. Without a catalogue nobody knows which signals the vehicle itself provides."""
    functions = [member for member in members if member.function is not None]
    chosen = list(_each_once(functions))
    findings = [*_same_names(functions, chosen)]
    links = _links(chosen)
    for consumer, provider in _pairs(links):
        findings.extend(_link_findings(consumer, provider))
    findings.extend(_rivals(links))
    if is_whole and catalogue is not None and not any(map(_is_incomplete, members)):
        findings.extend(_unprovided(links, catalogue))
    findings.extend(_order(chosen))
    findings.extend(_dependencies(chosen))
    return in_order(findings)


def _is_incomplete(member: Member) -> bool:
    """Whether signals of the function may be missing because they could not be resolved."""
    unresolved = (f for f in member.findings if f.severity == "error" and f.rule.startswith(("F00", "F01", "F02")))
    return member.function is None or next(unresolved, None) is not None


def _finding(rule: str, member: Member, pointer: Pointer, message: str, fix: str = "", path: str = "") -> Finding:
    place, at = member.locate(pointer)
    return Finding(rule, SEVERITIES[rule], message, member.file, *place, path, pointer_text(at), fix)


def _name(member: Member) -> str:
    assert member.function is not None
    return member.function.info.function_name


def _each_once(members: Iterable[Member]) -> Iterator[Member]:
    """Of a declaration and the Function JSON made of it, the declaration; of equal files, the first."""
    by_name: dict[str, Member] = {}
    for member in members:
        known = by_name.get(_name(member))
        if known is None or (member.is_declaration and not known.is_declaration):
            by_name[_name(member)] = member
    return iter(by_name.values())


def _same_names(members: Iterable[Member], chosen: Iterable[Member]) -> Iterator[Finding]:
    by_name = {_name(member): member for member in chosen}
    for member in members:
        other = by_name[_name(member)]
        if member is not other and member.digest != other.digest and member.is_declaration == other.is_declaration:
            message = f"The function {_name(member)!r} stands in {other.file!r} too."
            yield _finding("F108", member, ("FunctionInfo", "FunctionName"), message, "Rename one, or remove it.")


# -- links --------------------------------------------------------------------------------------------------------


class End(NamedTuple):
    """A signal at a call of a function."""

    member: Member
    pointer: Pointer
    call: Runnable
    datum: Datum


Links = Mapping[str, tuple[list[End], list[End]]]
"""Providers and consumers by signal: its path, or its name where a document has no paths."""


def _links(members: Iterable[Member]) -> Links:
    links: dict[str, tuple[list[End], list[End]]] = {}
    for member in members:
        assert member.function is not None
        for pointer, placed, datum in data(member.function):
            ends = links.setdefault(datum.vss_path or datum.name, ([], []))
            if datum.role in (PROVIDER, CONSUMER):
                ends[datum.role == CONSUMER].append(End(member, pointer, placed.runnable, datum))
    return links


def _pairs(links: Links) -> Iterator[tuple[End, End]]:
    """Consumers with their provider in another function, once for each item of a file."""
    for providers, consumers in links.values():
        for consumer in consumers:
            others = (end for end in providers if end.member is not consumer.member)
            provider = next(others, None)
            if provider is not None:
                yield consumer, provider


def _link_findings(consumer: End, provider: End) -> Iterator[Finding]:
    wanted, given = consumer.datum, provider.datum
    name, who = wanted.vss_path or wanted.name, _name(provider.member)
    for rule, key, message, fix in (
        ("F100", "Datatype", _other_datatype(consumer, provider), "Agree on one."),
        ("F101", "Units", _other_unit(wanted, given), "Agree on one, or give the path in the catalogue."),
        ("F102", "Min", _other_range(wanted, given), "Widen the range, or say what replaces others: rangeErrorAction."),
        ("F109", "Timeout", _too_short(wanted, provider.call), "Wait longer than one cycle of the provider."),
    ):
        if message:
            text = f"{who} provides {name!r} {message}."
            yield _finding(rule, consumer.member, (*consumer.pointer, key), text, fix, name)
    level, own = level_of(wanted.asil_level), level_of(given.asil_level)
    if level and own and rank(own) < rank(level):
        text = f"{who} provides {name!r} at {own}, and {_name(consumer.member)} needs {level}."
        yield _finding("F110", consumer.member, consumer.pointer, text, path=name)


def _other_datatype(consumer: End, provider: End) -> str:
    wanted, given = consumer.datum, provider.datum
    if wanted.vss_datatype and given.vss_datatype:
        if wanted.vss_datatype != given.vss_datatype:
            return f"as {given.vss_datatype}, and {wanted.vss_datatype} is expected"
        own, other = _symbols(consumer), _symbols(provider)
        return "with other numbers for its values" if own and other and own != other else ""
    own_type, other_type = _type(consumer), _type(provider)
    if own_type is None or other_type is None:
        return ""
    same = (c_type(own_type.c_definition) or own_type.c_definition) == (
        c_type(other_type.c_definition) or other_type.c_definition
    )
    return "" if same else f"as {other_type.c_definition}, and {own_type.c_definition} is expected"


def _type(end: End) -> Datatype | None:
    assert end.member.function is not None
    return next((t for t in end.member.function.datatypes if t.reference == end.datum.datatype), None)


def _symbols(end: End) -> Mapping[str, int]:
    if end.datum.datatype.removeprefix("DT_") in _PRIMITIVE:
        return {}
    datatype = _type(end)
    return {symbol.symbol: symbol.value for symbol in (datatype.symbols if datatype else None) or ()}


_PRIMITIVE = frozenset(("Bool", "Float32", "Float64", "UInt8", "UInt16", "UInt32", "SInt8", "SInt16", "SInt32"))
"""The usual datatypes, of which one need not ask whether they are enumerations."""


def _other_unit(wanted: Datum, given: Datum) -> str:
    both = bool(wanted.vss_path and given.vss_path)
    own, other = (wanted.vss_unit, given.vss_unit) if both else (wanted.units, given.units)
    return "" if (own or "") == (other or "") else f"in {other or 'no unit'}, and {own or 'no unit'} is expected"


def _other_range(wanted: Datum, given: Datum) -> str:
    """A consumer that says what replaces a value out of range has said what to do."""
    if wanted.range_error_action:
        return ""
    (low, high), (own_low, own_high) = _range(given), _range(wanted)
    if low is not None and own_low is not None and low < own_low - _slack(own_low):
        return f"down to {float(low):g}, and values from {float(own_low):g} on are expected"
    if high is not None and own_high is not None and high > own_high + _slack(own_high):
        return f"up to {float(high):g}, and values up to {float(own_high):g} are expected"
    return ""


def _slack(bound: Fraction) -> Fraction:
    """Rounding of limits that were converted and written as decimal numbers."""
    return abs(bound) * Fraction(1, 10**9)


def _range(datum: Datum) -> tuple[Fraction | None, Fraction | None]:
    """The range in the unit of the catalogue."""
    try:
        factor, offset = Fraction(datum.conversion_factor or 1), Fraction(datum.conversion_offset or 0)
    except (ValueError, ZeroDivisionError):
        return None, None
    ends = [None if end is None else Fraction(end) * factor + offset for end in (datum.min, datum.max)]
    return (ends[1], ends[0]) if factor < 0 else (ends[0], ends[1])


def _too_short(wanted: Datum, provider: Runnable) -> str:
    timeout, cycle = milliseconds(wanted.timeout), provider.cycle_time
    if timeout is None or not cycle or timeout >= cycle:
        return ""
    return f"every {cycle} ms, and its time-out is {timeout:g} ms"


def _rivals(links: Links) -> Iterator[Finding]:
    for name, (providers, _) in links.items():
        first = providers[0].member if providers else None
        for end in providers:
            if first is not None and end.member is not first:
                message = f"{_name(end.member)} provides {name!r}, which {_name(first)} provides too."
                yield _finding("F104", end.member, end.pointer, message, "One function provides a signal.", name)


def _unprovided(links: Links, catalogue: Catalogue) -> Iterator[Finding]:
    """Signals of the standard come from the vehicle, and attributes are set before it drives."""
    for name, (providers, consumers) in links.items():
        node = catalogue.get(name)
        if providers or node is None or node.type == "attribute" or not node.definition.statements[0].file.overlay:
            continue
        for end in consumers:
            if not end.datum.external_provider:
                message = f"No function provides {name!r}, and it is no signal of the standard."
                fix = "Add the function, or say who does: `provider`."
                yield _finding("F103", end.member, end.pointer, message, fix, name)


# -- order and errors ---------------------------------------------------------------------------------------------


class _Call(NamedTuple):
    """A call, and where it stands."""

    member: Member
    pointer: Pointer
    call: Runnable


def _order(members: Sequence[Member]) -> Iterator[Finding]:
    calls: dict[str, _Call] = {}
    for member in members:
        assert member.function is not None
        for pointer, _, call in runnables(member.function):
            calls.setdefault(call.name, _Call(member, pointer, call))
    own = {_name(member) for member in members}
    for name, (member, pointer, call) in calls.items():
        at = (*pointer, "PrevRunnable")
        for previous in previous_calls(call):
            other = calls.get(previous)
            if other is None:
                function = previous.rpartition("_")[0]
                if function in own and function != _name(member):
                    message = f"{name} runs after {previous!r}, which does not exist."
                    yield _finding("F107", member, at, message, did_you_mean(previous, calls), name)
            elif other.member is not member:
                reason = contradiction(call, other.call)
                if reason:
                    yield _finding("F105", member, at, f"{name} runs after {previous}, {reason}.", path=name)
                if _reaches(name, {n: previous_calls(c.call) for n, c in calls.items()}):
                    yield _finding("F106", member, at, f"{name} runs after itself, by way of {previous}.", path=name)


def _dependencies(members: Sequence[Member]) -> Iterator[Finding]:
    declared = {e.name: (m, p, e) for m in members if m.function for p, _, e in errors(m.function)}
    depends = {name: error.dependencies for name, (_, _, error) in declared.items()}
    for name, (member, pointer, error) in declared.items():
        others = [other for other in error.dependencies if other in declared and declared[other][0] is not member]
        if others and _reaches(name, depends):
            message = f"{name} depends on itself, by way of {', '.join(others)}."
            yield _finding("F111", member, (*pointer, "Dependancy"), message, path=name)


def _reaches(start: str, following: Mapping[str, tuple[str, ...]]) -> bool:
    waiting, seen = list(following[start]), set[str]()
    while waiting:
        name = waiting.pop()
        if name == start:
            return True
        if name not in seen:
            seen.add(name)
            waiting.extend(following.get(name, ()))
    return False
