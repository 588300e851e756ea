"""Modes of a function: those that its mode interfaces know, each with the calls that can run in it."""

from collections.abc import Collection, Iterator

from sigcat import codes
from sigcat.function.checks.order import previous_calls
from sigcat.function.document.hints import Hints
from sigcat.function.document.problem import Problem, Subject
from sigcat.function.function_json.model import FunctionJson, Mode
from sigcat.function.function_json.walk import Located, runnables
from sigcat.names import either

Problems = Iterator[Problem]

_OUTSIDE_MODES = frozenset(("Init", "Shutdown"))
"""Run types of calls that are made before the first mode and after the last one."""


def check_modes(function: FunctionJson) -> Problems:
    """Every problem of modes."""
    calls = {located.runnable.name: located for located in runnables(function)}
    unknown = list(_unknown_calls(function, calls))
    yield from unknown
    yield from _names(function)
    yield from _without_entry(function)
    if not unknown:  # a call may be in no mode because its name is misspelled there
        yield from _in_no_mode(function, calls)
    for i, mode in enumerate(function.modes or ()):
        yield from _previous_calls(i, mode, calls)


def _unknown_calls(function: FunctionJson, calls: Collection[str]) -> Problems:
    hint = Hints()
    last_names = [name.removeprefix(f"{function.info.function_name}_") for name in calls]
    for i, mode in enumerate(function.modes or ()):
        subject = Subject("mode", mode.name)
        for j, name in enumerate(mode.runnables):
            if name not in calls:
                message = f"Mode {mode.name!r} must run calls of the function, not {name!r}, which does not exist."
                at, fix = ("ModesList", i, "RunnablesList", j), hint(name, calls) or hint(name, last_names)
                cause = Subject("scheduling", name)
                yield Problem(codes.MODE_RUNS_UNKNOWN_CALL, at, message, fix, subject, cause)


def _names(function: FunctionJson) -> Problems:
    hint = Hints()
    allowed = dict.fromkeys(mode for interface in function.mode_interfaces or () for mode in interface.modes)
    for i, mode in enumerate(function.modes or ()):
        if allowed and mode.name not in allowed:
            message = f"The mode must be one that the mode interfaces allow, not {mode.name!r}."
            fix, subject = hint(mode.name, allowed) or f"Use one of {', '.join(allowed)}.", Subject("mode", mode.name)
            yield Problem(codes.MODE_NOT_IN_INTERFACE, ("ModesList", i, "Name"), message, fix, subject)


def _without_entry(function: FunctionJson) -> Problems:
    """Modes that the function can be asked to take, and of which it does not say what runs in them."""
    modes = function.modes or ()
    interfaces = function.mode_interfaces or ()
    asked = [each for each in interfaces if each.direction == "In"] or interfaces
    allowed = dict.fromkeys(mode for interface in asked for mode in interface.modes)
    listed = {mode.name for mode in modes}
    lacking = [mode for mode in allowed if mode not in listed]
    if lacking and listed <= allowed.keys():  # otherwise a mode may only be misspelled
        at = ("ModesList",) if modes else ("ModeInterfaceList", 0)
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
