"""Modes of a function: those that its mode interfaces know, each with the calls that can run in it."""

from collections.abc import Collection, Sequence

from sigcat import codes
from sigcat.function.checks.schedule.order import previous_calls
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.function.function_json.datatypes.primitive_types import integer_limits
from sigcat.function.function_json.interfaces.status_interfaces import ModeInterface
from sigcat.function.function_json.model import FunctionJson, Mode
from sigcat.function.function_json.runnable import Runnable
from sigcat.function.function_json.walk import Located, modes, runnables, safety_reactions, subject_of
from sigcat.names import did_you_mean, either

_OUTSIDE_MODES = frozenset(("Init", "Shutdown"))
"""Run types of calls that are made before the first mode and after the last one."""


def check_modes(function: FunctionJson) -> Problems:
    """Every problem of modes."""
    calls = {located.runnable.name: located for located in runnables(function)}
    unknown = list(_unknown_calls(function, calls))
    yield from unknown
    yield from _names(function)
    yield from _initial(function)
    yield from _numbers(function)
    yield from _values(function)
    yield from _untold(function)
    yield from _without_entry(function)
    if not unknown:  # a call may be in no mode because its name is misspelled there
        yield from _in_no_mode(function, calls)
    for i, mode in enumerate(function.modes or ()):
        yield from _previous_calls(i, mode, calls)


def _unknown_calls(function: FunctionJson, calls: Collection[str]) -> Problems:
    last_names = [name.removeprefix(f"{function.info.function_name}_") for name in calls]
    for i, mode in enumerate(function.modes or ()):
        subject = Subject("mode", mode.name)
        for j, name in enumerate(mode.runnables):
            if name not in calls:
                message = f"Mode {mode.name!r} must run calls of the function, not {name!r}, which does not exist."
                fix = did_you_mean(name, calls) or did_you_mean(name, last_names)
                at, cause = ("ModesList", i, "RunnablesList", j), Subject("scheduling", name)
                yield Problem(codes.MODE_RUNS_UNKNOWN_CALL, at, message, fix, subject, cause)


def _names(function: FunctionJson) -> Problems:
    allowed = dict.fromkeys(mode for interface in function.mode_interfaces or () for mode in interface.modes)
    for i, mode in enumerate(function.modes or ()):
        if allowed and mode.name not in allowed:
            message = f"The mode must be one that the mode interfaces allow, not {mode.name!r}."
            at, subject = ("ModesList", i, "Name"), Subject("mode", mode.name)
            fix = did_you_mean(mode.name, allowed) or f"Use one of {', '.join(allowed)}."
            yield Problem(codes.MODE_NOT_IN_INTERFACE, at, message, fix, subject)


def _initial(function: FunctionJson) -> Problems:
    """Report initial modes, and initial values of safety reactions, that are not allowed."""
    for pointer, mode in modes(function):
        if mode.initial is not None and mode.initial not in mode.modes:
            at = (*pointer, "Initial")
            yield _not_allowed("The initial mode", mode.initial, mode.modes, at, subject_of(mode))
    types = {datatype.reference: datatype for datatype in function.datatypes}
    for pointer, _, reaction in safety_reactions(function):
        datatype = types.get(reaction.datatype)
        allowed = [each.symbol for each in (datatype.symbols or ())] if datatype else []
        if reaction.initial is not None and allowed and reaction.initial not in allowed:
            what, at = f"`initial` of {reaction.name}", (*pointer, "Initial")
            yield _not_allowed(what, reaction.initial, allowed, at, subject_of(reaction))


def _not_allowed(what: str, word: str, allowed: Sequence[str], at: Pointer, subject: Subject) -> Problem:
    message = f"{what} must be {either(allowed) if allowed else 'one that is allowed'}, not {word!r}."
    return Problem(codes.INITIAL_NOT_ALLOWED, at, message, did_you_mean(word, allowed), subject)


def _numbers(function: FunctionJson) -> Problems:
    """Each mode is allowed once, and has a number where the datatype has numbers."""
    types = {datatype.reference: datatype for datatype in function.datatypes}
    for index, mode in enumerate(function.mode_interfaces or ()):
        datatype = types.get(mode.datatype)
        symbols = {each.symbol for each in (datatype.symbols if datatype else None) or ()}
        subject = Subject("mode", mode.name)
        for position, name in enumerate(mode.modes):
            at = ("ModeInterfaceList", index, "Modes", position)
            if name in mode.modes[:position]:
                message = f"{mode.name} must allow each mode once, not {name!r} again."
                yield Problem(codes.ENUMERATION_MISCODED, at, message, "Remove it.", subject)
            elif symbols and name not in symbols:
                message = f"The datatype of {mode.name} must have a number for the mode {name!r}."
                fix = did_you_mean(name, symbols) or f"Add it to `Symbols` of {mode.datatype}."
                yield Problem(codes.ENUMERATION_MISCODED, at, message, fix, subject)


def _values(function: FunctionJson) -> Problems:
    """Numbers of modes in the code: one for each, and each its own."""
    for index, mode in enumerate(function.mode_interfaces or ()):
        if mode.values is None:
            continue
        at, subject = ("ModeInterfaceList", index, "Values"), Subject("mode", mode.name)
        numbers = {each.symbol: each.value for each in mode.values}
        lacking = [name for name in mode.modes if name not in numbers]
        if lacking:
            message = f"`values` of {mode.name} must have {', '.join(map(repr, lacking))}."
            yield Problem(codes.ENUMERATION_MISCODED, at, message, "Give each mode a number.", subject)
        for position, name in enumerate(numbers):
            if name not in mode.modes:
                message = f"{mode.name} does not allow {name!r}."
                fix = did_you_mean(name, mode.modes) or "Remove it."
                yield Problem(codes.ENUMERATION_MISCODED, (*at, position), message, fix, subject)
        low, high = _limits_in_code(mode, function) or _WIDEST
        for position, each in enumerate(mode.values):
            if not low <= each.value <= high:
                message = f"The number of {each.symbol!r} must be {low} to {high}, not {each.value}: its variable holds no other."
                fix = "Give another number, or the variable's type as `cType`."
                yield Problem(codes.ENUMERATION_MISCODED, (*at, position, "Value"), message, fix, subject)
        if len(set(numbers.values())) < len(mode.values):
            message, fix = f"Two modes of {mode.name} have the same number.", "Give each mode its own number."
            yield Problem(codes.ENUMERATION_MISCODED, at, message, fix, subject)


_WIDEST = -(2**63) + 1, 2**63 - 1
"""Range of a variable whose type only the headers of the function know."""


def _limits_in_code(mode: ModeInterface, function: FunctionJson) -> tuple[int, int] | None:
    """Limits of a mode's variable, where the document has its type; None if a header has it, or without a variable."""
    if mode.variable is None or mode.c_type is not None:
        return integer_limits(mode.c_type or "")
    if mode.defined_by != "Adapter" and function.code and function.code.headers:
        return None
    definitions = {each.reference: each.c_definition for each in function.datatypes}
    return integer_limits(definitions.get(mode.datatype, ""))


def _untold(function: FunctionJson) -> Problems:
    """Errors of modes that are not allowed, where such a mode leads to one in which nothing evaluates them."""
    running = {mode.name: mode.runnables for mode in function.modes or ()}
    for index, mode in enumerate(function.mode_interfaces or ()):
        if mode.unknown_action != "Initial" or not mode.unknown_error or not mode.modes:
            continue
        initial = mode.initial or mode.modes[0]
        tell = [call.name for _, _, call in runnables(function) if mode.unknown_error in _evaluated(call)]
        if tell and initial in running and not any(name in running[initial] for name in tell):
            message = f"{mode.unknown_error} must be evaluated in the mode {initial!r}, to which a mode that is not allowed leads; {either(tell)} does not run there."
            fix = "Keep the last mode, with `unknown: keep`, or let the call run in the initial one."
            at = ("ModeInterfaceList", index, "UnknownError")
            yield Problem(codes.UNKNOWN_MODE_UNTOLD, at, message, fix, Subject("mode", mode.name))


def _evaluated(call: Runnable) -> Collection[str]:
    """Errors that a call evaluates; Init and Terminate evaluate none."""
    if call.run_type in _OUTSIDE_MODES:
        return ()
    return {error.name for contract in call.contracts or () for error in contract.errors or ()}


def _without_entry(function: FunctionJson) -> Problems:
    """Modes that the function can be asked to take, and of which it does not say what runs in them."""
    listed = {mode.name for mode in function.modes or ()}
    interfaces = function.mode_interfaces or ()
    asked = [each for each in interfaces if each.direction == "In"] or interfaces
    allowed = dict.fromkeys(mode for interface in asked for mode in interface.modes)
    lacking = [mode for mode in allowed if mode not in listed]
    if lacking and listed <= allowed.keys():  # otherwise a mode may only be misspelled
        at = ("ModesList",) if function.modes else ("ModeInterfaceList", 0)
        message = f"Every mode must say which calls run in it; {either(map(repr, lacking))} does not."
        fix = "List it under `active`, with no calls if none runs in it."
        yield Problem(codes.MODE_WITHOUT_ENTRY, at, message, fix, Subject("mode", lacking[0]))


def _in_no_mode(function: FunctionJson, calls: dict[str, Located]) -> Problems:
    running = {name for mode in function.modes or () for name in mode.runnables}
    for name, located in calls.items():
        if function.modes and name not in running and located.runnable.run_type not in _OUTSIDE_MODES:
            message, fix = f"{name} must run in a mode; no mode lists it.", "Add it to the modes in which it runs."
            yield Problem(codes.CALL_IN_NO_MODE, located.pointer, message, fix, Subject("scheduling", name))


def _previous_calls(index: int, mode: Mode, calls: dict[str, Located]) -> Problems:
    for j, name in enumerate(mode.runnables):
        for previous in previous_calls(calls[name].runnable) if name in calls else ():
            other = calls.get(previous)
            if other and previous not in mode.runnables and other.runnable.run_type not in _OUTSIDE_MODES:
                message = f"Mode {mode.name!r} must run {previous} too: {name} runs after it."
                at, fix = ("ModesList", index, "RunnablesList", j), "Add it to the mode, or let the call wait for none."
                yield Problem(codes.PREVIOUS_CALL_NOT_IN_MODE, at, message, fix, Subject("mode", mode.name))
