"""A set of functions: what fits in each of them, and not together."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.file_kind import is_json
from sigcat.findings import Finding, in_order
from sigcat.function.build.build import place_in, resolved
from sigcat.function.build.defining import layered
from sigcat.function.checks.order import contradiction, in_circles, previous_calls
from sigcat.function.checks.validate import validated
from sigcat.function.declaration.declaration import Declared, read_declaration
from sigcat.function.document.document import Document, Place, Pointer, pointer_text, read_json
from sigcat.function.document.hints import Hints
from sigcat.function.document.severities import SEVERITIES
from sigcat.function.function_json.model import FunctionJson, Runnable
from sigcat.function.function_json.walk import errors, runnables
from sigcat.function.sets.wiring import Wiring, connect
from sigcat.limits import DEFAULT_LIMITS, Limits


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


@collector_paused()
def check_functions(
    files: Sequence[tuple[bytes, str]],
    catalogue: Catalogue,
    limits: Limits = DEFAULT_LIMITS,
    *,
    is_whole: bool = True,
) -> tuple[Finding, ...]:
    """Everything that is wrong with function files, alone and together. What one defines, the others may use.

    `is_whole`: there are no further functions, so that what nobody here provides, nobody provides.
    """
    members, over = read_set(files, catalogue, limits)
    alone = [finding for member in members for finding in member.findings]
    return in_order([*alone, *check_set(members, over, is_whole=is_whole)])


def read_set(
    files: Sequence[tuple[bytes, str]], catalogue: Catalogue, limits: Limits = DEFAULT_LIMITS
) -> tuple[tuple[Member, ...], Catalogue]:
    """The functions of files, and the catalogue with everything that they define."""
    read = [
        read_json(data, name, limits) if is_json(data, name) else read_declaration(data, name, limits)
        for data, name in files
    ]
    over = with_definitions((each for each in read if isinstance(each, Declared)), catalogue)
    return tuple(
        _of_declaration(each, over) if isinstance(each, Declared) else _of_json(each, over) for each in read
    ), over


def with_definitions(declarations: Iterable[Declared], catalogue: Catalogue) -> Catalogue:
    """The catalogue with everything that the declarations define: what one defines, the others may use."""
    for declared in declarations:
        if declared.declaration is not None:
            catalogue = layered(declared.declaration, declared.document, catalogue)
    return catalogue


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
    named = {_name(member): member for member in chosen}
    wiring = connect([member.function for member in chosen if member.function is not None])
    findings.extend(_misfits(wiring, named))
    findings.extend(_rivals(wiring, named))
    if is_whole and catalogue is not None and not any(map(_is_incomplete, members)):
        findings.extend(_unprovided(wiring, named, catalogue))
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


def _misfits(wiring: Wiring, members: Mapping[str, Member]) -> Iterator[Finding]:
    for link in wiring.links:
        end = link.consumer
        for rule, key, message, fix in link.misfits:
            at = (*end.pointer, key) if key else end.pointer
            yield _finding(rule, members[end.function], at, message, fix, link.path)


def _rivals(wiring: Wiring, members: Mapping[str, Member]) -> Iterator[Finding]:
    for path, (first, *others) in wiring.rivals:
        for end in others:
            message = f"{end.function} provides {path!r}, which {first.function} provides too."
            fix = "One function provides a signal."
            yield _finding("F104", members[end.function], end.pointer, message, fix, path)


def _unprovided(wiring: Wiring, members: Mapping[str, Member], catalogue: Catalogue) -> Iterator[Finding]:
    """Signals of the standard come from the vehicle, and attributes are set before it drives."""
    for end in wiring.from_outside:
        node = catalogue.get(end.path)
        if node is None or node.type == "attribute" or not node.definition.statements[0].file.overlay:
            continue
        if not end.signal.external_provider:
            message = f"No function provides {end.path!r}, and it is no signal of the standard."
            fix = "Add the function, or say who does: `provider`."
            yield _finding("F103", members[end.function], end.pointer, message, fix, end.path)


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
    hint = Hints()
    circular = in_circles({name: previous_calls(each.call) for name, each in calls.items()})
    for name, (member, pointer, call) in calls.items():
        at = (*pointer, "PrevRunnable")
        for previous in previous_calls(call):
            other = calls.get(previous)
            if other is None:
                function = previous.rpartition("_")[0]
                if function in own and function != _name(member):
                    message = f"{name} runs after {previous!r}, which does not exist."
                    yield _finding("F107", member, at, message, hint(previous, calls), name)
            elif other.member is not member:
                reason = contradiction(call, other.call)
                if reason:
                    yield _finding("F105", member, at, f"{name} runs after {previous}, {reason}.", path=name)
                if name in circular:
                    yield _finding("F106", member, at, f"{name} runs after itself, by way of {previous}.", path=name)


def _dependencies(members: Sequence[Member]) -> Iterator[Finding]:
    declared = {e.name: (m, p, e) for m in members if m.function for p, _, e in errors(m.function)}
    circular = in_circles({name: error.dependencies for name, (_, _, error) in declared.items()})
    for name, (member, pointer, error) in declared.items():
        others = [other for other in error.dependencies if other in declared and declared[other][0] is not member]
        if others and name in circular:
            message = f"{name} depends on itself, by way of {', '.join(others)}."
            yield _finding("F111", member, (*pointer, "Dependancy"), message, path=name)
