"""A set of functions: what fits in each of them, and not together."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Generic, NamedTuple, TypeVar

from sigcat import codes
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.network.mapping_attributes import RECEIVED
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.findings import Finding, in_order
from sigcat.function.checks.circles import circles
from sigcat.function.checks.schedule.order import contradiction, previous_calls
from sigcat.function.code_files import CodeCheck
from sigcat.function.document.document import Pointer
from sigcat.function.exchange import Side
from sigcat.function.function_file import CheckedFunction, check_files, read_function_file
from sigcat.function.function_json.interfaces.status_interfaces import ErrorInterface
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.function_json.runnable import Runnable
from sigcat.function.function_json.walk import errors, runnables
from sigcat.function.sets.wiring import Wiring, connect
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.names import did_you_mean

Findings = Iterator[Finding]


@collector_paused()
def check_functions(
    files: Sequence[tuple[bytes, str]],
    catalogue: Catalogue,
    limits: Limits = DEFAULT_LIMITS,
    *,
    is_whole: bool = True,
    check_code: CodeCheck | None = None,
) -> tuple[Finding, ...]:
    """Everything that is wrong with function files, alone and together. What one defines, the others may use.

    `is_whole`: the set is complete, so that signals which none of these provides are not provided. `check_code`
    checks the files of the code.
    """
    members, over = read_set(files, catalogue, limits, check_code)
    alone = [finding for member in members for finding in member.findings]
    return in_order([*alone, *check_set(members, over, is_whole=is_whole)])


def read_set(
    files: Sequence[tuple[bytes, str]],
    catalogue: Catalogue,
    limits: Limits = DEFAULT_LIMITS,
    check_code: CodeCheck | None = None,
) -> tuple[tuple[CheckedFunction, ...], Catalogue]:
    """The functions of files, and the catalogue with everything that they define."""
    return check_files([read_function_file(data, name, limits) for data, name in files], catalogue, check_code)


def check_set(
    members: Sequence[CheckedFunction], catalogue: Catalogue | None = None, *, is_whole: bool = True
) -> tuple[Finding, ...]:
    """Return mismatches of functions. Without a catalogue, signals that the vehicle itself provides are unknown."""
    chosen = _each_once(members)
    functions = [member.resolved for member in chosen.values() if member.resolved is not None]
    by_name = {function.name: function for function in functions}
    wiring = connect([function.function for function in functions])
    findings = [*_same_names(members, chosen), *_mismatches(wiring, by_name), *_rivals(wiring, by_name)]
    if is_whole and catalogue is not None and not any(member.is_incomplete for member in members):
        findings.extend(_unprovided(wiring, by_name, catalogue))
        findings.extend(_unmapped(wiring, by_name, catalogue))
    return in_order([*findings, *_order(functions), *_dependencies(functions)])


def _each_once(members: Iterable[CheckedFunction]) -> Mapping[str, CheckedFunction]:
    """By name, of a declaration and the Function JSON made of it, the declaration; of equal files, the first."""
    by_name: dict[str, CheckedFunction] = {}
    for member in members:
        if member.resolved is None:
            continue
        known = by_name.get(member.resolved.name)
        if known is None or (member.is_declaration and not known.is_declaration):
            by_name[member.resolved.name] = member
    return by_name


def _same_names(members: Iterable[CheckedFunction], chosen: Mapping[str, CheckedFunction]) -> Findings:
    for member in members:
        if member.resolved is None:
            continue
        other, name = chosen[member.resolved.name], member.resolved.name
        is_copy = member.document.digest == other.document.digest
        if member is not other and not is_copy and member.is_declaration == other.is_declaration:
            message = f"The function {name!r} is in {other.document.name!r} too."
            pointer = ("FunctionInfo", "FunctionName")
            yield member.resolved.finding(codes.FUNCTION_TWICE, pointer, message, "Rename one, or remove it.")


# -- links --------------------------------------------------------------------------------------------------------


def _mismatches(wiring: Wiring, functions: Mapping[str, ResolvedFunction]) -> Findings:
    for link in wiring.links:
        end = link.consumer
        for rule, key, message, fix in link.mismatches:
            pointer = (*end.pointer, key) if key else end.pointer
            yield functions[end.function].finding(rule, pointer, message, fix, link.path)


def _rivals(wiring: Wiring, functions: Mapping[str, ResolvedFunction]) -> Findings:
    for path, (first, *others) in wiring.rivals:
        for end in others:
            message = f"{path!r} must have one provider; {first.function} and {end.function} provide it."
            fix = "Remove it from one of them."
            yield functions[end.function].finding(codes.PROVIDED_TWICE, end.pointer, message, fix, path)


def _unprovided(wiring: Wiring, functions: Mapping[str, ResolvedFunction], catalogue: Catalogue) -> Findings:
    for end in wiring.from_outside:
        if needs_provider(end, catalogue):
            message = f"No function provides {end.identity!r}, and it is not a signal of the standard."
            fix = "Add the function, or name the provider under `provider`. If this one provides it, write `role: provided`."
            rule = codes.CONSUMED_AND_NOT_PROVIDED
            yield functions[end.function].finding(rule, end.pointer, message, fix, end.identity)


def needs_provider(end: Side, catalogue: Catalogue) -> bool:
    """Whether another function must provide a consumed signal.

    Signals of the standard come from the vehicle, and attributes are set before it drives.
    """
    node = catalogue.get(end.identity)
    if node is None or node.type == "attribute" or not node.definition.statements[0].file.overlay:
        return False
    return not end.data.external_provider and not end.data.is_optional


def _unmapped(wiring: Wiring, functions: Mapping[str, ResolvedFunction], catalogue: Catalogue) -> Findings:
    """Report signals from outside that a catalogue with mappings to a network does not map."""
    if catalogue.attributes.isdisjoint(RECEIVED):
        return
    for end in wiring.from_outside:
        node = catalogue.get(end.identity)
        if node is not None and node.type != "attribute" and node.values.keys().isdisjoint(RECEIVED):
            message = f"{end.identity!r} comes from outside, and nothing maps it to a network."
            rule = codes.CONSUMED_AND_NOT_MAPPED
            yield functions[end.function].finding(rule, end.pointer, message, path=end.identity)


# -- order and errors ---------------------------------------------------------------------------------------------


_Part = TypeVar("_Part", Runnable, ErrorInterface)


class _Placed(NamedTuple, Generic[_Part]):
    """A call or an error of a function, and where it stands."""

    function: ResolvedFunction
    pointer: Pointer
    part: _Part


def _order(functions: Sequence[ResolvedFunction]) -> Findings:
    calls: dict[str, _Placed[Runnable]] = {}
    for function in functions:
        for pointer, _, runnable in runnables(function.function):
            calls.setdefault(runnable.name, _Placed(function, pointer, runnable))
    names = {function.name for function in functions}
    circle_of = circles({n: previous_calls(each.part) for n, each in calls.items()}, "scheduling", "previousRunnable")
    for name, call in calls.items():
        for previous in previous_calls(call.part):
            other = calls.get(previous)
            if other is None:
                yield from _unknown_previous(name, call, previous, names, did_you_mean(previous, calls))
            elif other.function is not call.function:
                yield from _across(call, other, is_circular=name in circle_of)


def _unknown_previous(
    name: str, call: _Placed[Runnable], previous: str, functions: Iterable[str], hint: str
) -> Findings:
    """A call of another function of the set that does not exist; those of this one are checked alone."""
    function = previous.rpartition("_")[0]
    if function in functions and function != call.function.name:
        message = f"{name} must run after a call that exists, not after {previous!r}."
        pointer = (*call.pointer, "PrevRunnable")
        yield call.function.finding(codes.PREVIOUS_CALL_OF_ANOTHER_UNKNOWN, pointer, message, hint, name)


def _across(call: _Placed[Runnable], other: _Placed[Runnable], *, is_circular: bool) -> Findings:
    """An order of calls of two functions that cannot be kept."""
    name, previous, pointer = call.part.name, other.part.name, (*call.pointer, "PrevRunnable")
    found = contradiction(call.part, other.part)
    if found:
        rule = codes.ORDER_CONTRADICTS_PRIORITY_OF_ANOTHER
        yield call.function.finding(rule, pointer, found.message, found.fix, name)
    if is_circular:
        message = f"{name} depends on itself, through {previous}."
        yield call.function.finding(codes.CALLS_OF_FUNCTIONS_IN_A_CIRCLE, pointer, message, path=name)


def _dependencies(functions: Sequence[ResolvedFunction]) -> Findings:
    declared = {error.name: _Placed(each, p, error) for each in functions for p, _, error in errors(each.function)}
    circle_of = circles({name: each.part.dependencies for name, each in declared.items()}, "error", "dependency")
    for name, (function, pointer, error) in declared.items():
        others = [
            other for other in error.dependencies if other in declared and declared[other].function is not function
        ]
        if others and name in circle_of:
            message = f"{name} depends on itself, through {', '.join(others)}."
            at = (*pointer, "Dependancy")
            yield function.finding(codes.ERRORS_OF_FUNCTIONS_IN_A_CIRCLE, at, message, path=name)
