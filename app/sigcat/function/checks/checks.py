"""Checks of a Function JSON in itself: what holds of every function, wherever its document comes from."""

import re
from collections.abc import Callable, Collection, Iterable, Iterator

from sigcat.asil import is_above, level_of
from sigcat.function.checks.order import contradiction, in_circles, previous_calls
from sigcat.function.document.document import Pointer
from sigcat.function.document.hints import Hints
from sigcat.function.document.problem import Problem
from sigcat.function.function_json.model import PROVIDER, FunctionJson, Runnable, WatchdogLimits, milliseconds
from sigcat.function.function_json.walk import (
    Placed,
    contracts,
    data,
    errors,
    methods,
    parameters,
    references,
    runnables,
)
from sigcat.names import camel_case

Problems = Iterator[Problem]

_CAMEL = re.compile(r"[A-Z][A-Za-z0-9]*")


def check(function: FunctionJson, known_errors: Collection[str] = ()) -> Problems:
    """Every problem of a function. `known_errors` are names of errors that others declare."""
    for one in _CHECKS:
        yield from one(function)
    for other in _CHECKS_OF_ERRORS:
        yield from other(function, known_errors)


# -- names --------------------------------------------------------------------------------------------------------


def _names_twice(function: FunctionJson) -> Problems:
    named: dict[Pointer, list[tuple[Pointer, str]]] = {}
    for pointer, placed, item in (*data(function), *parameters(function)):
        named.setdefault(placed.pointer, []).append(((*pointer, "Name"), item.name))
    for items in named.values():
        for place, name in _repeated(items):
            yield Problem("F030", place, f"The name {name!r} is used twice in one call.", "Rename one.", name)


def _variables_twice(function: FunctionJson) -> Problems:
    """In one call a variable holds one interface; in another call of the component it holds the same one."""
    holders: dict[tuple[str, str], tuple[Pointer, str]] = {}
    for pointer, placed, item in (*data(function), *parameters(function)):
        if not item.variable:
            continue
        held = (placed.pointer, item.vss_path or item.name)
        known = holders.setdefault((placed.component.name, item.variable), held)
        if known is not held and (known[0] == held[0] or known[1] != held[1]):
            where = "one call" if known[0] == held[0] else f"component {placed.component.name!r}"
            message = f"The variable {item.variable!r} holds two interfaces of {where}."
            yield Problem("F031", (*pointer, "Variable"), message, "Give each a variable of its own.")


def _calls_twice(function: FunctionJson) -> Problems:
    named = [((*pointer, "Name"), runnable.name) for pointer, _, runnable in runnables(function)]
    for place, name in _repeated(named):
        yield Problem("F036", place, f"The call {name!r} is listed twice.", "Remove one, or name it otherwise.", name)


def _repeated(named: Iterable[tuple[Pointer, str]]) -> Iterator[tuple[Pointer, str]]:
    seen: set[str] = set()
    for place, name in named:
        if name in seen:
            yield place, name
        seen.add(name)


def _conventional_names(function: FunctionJson) -> Problems:
    own = function.info.function_name
    for pointer, component, runnable in runnables(function):
        prefixes = (f"{own}_", f"{component.name}_")
        if not runnable.name.startswith(prefixes):
            fix = f"Name it {own}_Init, {own}_Step or {own}_Terminate."
            yield Problem("F032", (*pointer, "Name"), f"The call {runnable.name!r} does not start with {own!r}.", fix)
    for pointer, _, contract in contracts(function):
        for i, error in enumerate(contract.errors or ()):
            if not (error.name.startswith(f"{own}_") and error.name.endswith("_ErrorSts")):
                message = f"{error.name!r} does not follow {own}_<ErrorName>_ErrorSts."
                yield Problem("F032", (*pointer, "ErrorList", i, "Name"), message, path=error.name)
        for i, reaction in enumerate(contract.safety_reactions or ()):
            if not reaction.name.endswith("_SftyCondSts"):
                message = f"{reaction.name!r} does not follow <SafetyCondition>_SftyCondSts."
                yield Problem("F032", (*pointer, "SafetyReactionList", i, "Name"), message, path=reaction.name)


def _mode_names(function: FunctionJson) -> Problems:
    own = function.info.function_name
    for i, interface in enumerate(function.mode_interfaces or ()):
        if interface.name not in (f"{own}_Mode_In", f"{own}_Mode_Out"):
            message = f"{interface.name!r} does not follow {own}_Mode_In and {own}_Mode_Out."
            yield Problem("F032", ("ModeInterfaceList", i, "Name"), message, path=interface.name)


def _function_name(function: FunctionJson) -> Problems:
    name = function.info.function_name
    if not _CAMEL.fullmatch(name):
        fix = f"Name it {camel_case(name)!r}." if _CAMEL.fullmatch(camel_case(name)) else "Use letters and digits."
        yield Problem("F035", ("FunctionInfo", "FunctionName"), f"{name!r} is not CamelCase.", fix, name)


def _identifiers(function: FunctionJson) -> Problems:
    for pointer, _, item in (*data(function), *parameters(function), *methods(function)):
        if not (item.name.isascii() and item.name.isidentifier()):
            message = f"{item.name!r} is no identifier of C."
            fix = "Use letters, digits and underscores, and a letter first."
            yield Problem("F033", (*pointer, "Name"), message, fix, item.name)


def _expressions(function: FunctionJson) -> Problems:
    for pointer, _, item in (*data(function), *parameters(function)):
        if item.variable and not _may_be_expression(item.variable):
            fix = "Name the variable as the code does, such as in.speed, in->speed or in[3]."
            message = f"{item.variable!r} is no expression of C."
            yield Problem("F037", (*pointer, "Variable"), message, fix, item.vss_path or item.name)


def _may_be_expression(text: str) -> bool:
    """Whether brackets are closed in order, and no digit comes first. The rest is left to the compiler."""
    waiting: list[str] = []
    for character in text:
        if character in "([":
            waiting.append(")" if character == "(" else "]")
        elif character in ")]" and (not waiting or waiting.pop() != character):
            return False
    return not waiting and not text.lstrip()[:1].isdigit()


# -- ranges -------------------------------------------------------------------------------------------------------


def _ranges(function: FunctionJson) -> Problems:
    for pointer, _, item in (*data(function), *parameters(function)):
        if item.min is not None and item.max is not None and item.min > item.max:
            message = f"The range from {item.min} to {item.max} of {item.name!r} is upside down."
            yield Problem("F023", (*pointer, "Min"), message, path=item.vss_path or item.name)
            continue
        starts = (("InitValue", item.init_value), ("Default", getattr(item, "default", None)))
        for key, value in starts:
            if value is not None and _is_outside(value, item.min, item.max):
                message = f"`{key}` {value} of {item.name!r} lies outside its range."
                yield Problem("F024", (*pointer, key), message, path=item.vss_path or item.name)


def _is_outside(value: float, low: float | None, high: float | None) -> bool:
    return (low is not None and value < low) or (high is not None and value > high)


# -- time-outs ----------------------------------------------------------------------------------------------------


def _time_outs(function: FunctionJson, known: Collection[str]) -> Problems:
    hint = Hints()
    declared = dict.fromkeys(error.name for _, _, error in errors(function))
    for pointer, (_, _, runnable), item in data(function):
        duration = milliseconds(item.timeout)
        if duration is not None and runnable.cycle_time and duration < runnable.cycle_time:
            message = (
                f"The time-out of {item.name!r}, {duration:g} ms, is shorter than the cycle, {runnable.cycle_time} ms."
            )
            fix = "It would pass before the value can be looked at twice: make it at least the cycle time."
            yield Problem("F040", (*pointer, "Timeout"), message, fix, item.name)
        if item.timeout_error and duration is None and item.timeout is None:
            message = f"{item.name!r} has the time-out error {item.timeout_error!r}, but no time-out that would set it."
            fix = "Give `timeout`, the longest time between two values in ms, or remove the error."
            yield Problem("F043", (*pointer, "TimeoutError"), message, fix, item.name)
        if item.timeout_error and item.timeout_error not in declared:
            message = f"The function does not declare the time-out error {item.timeout_error!r} of {item.name!r}."
            fix = _declared_or_meant(item.timeout_error, declared, known, hint)
            yield Problem("F041", (*pointer, "TimeoutError"), message, fix, item.name)


def _declared_or_meant(name: str, declared: Collection[str], known: Collection[str], hint: Hints) -> str:
    """What to do about an error that no call declares: one that exists was not mistyped."""
    return (name not in known and hint(name, declared)) or "Add it to the errors of the call."


def _durations(function: FunctionJson) -> Problems:
    for pointer, _, item in data(function):
        yield from _duration((*pointer, "Timeout"), item.timeout)
    for pointer, _, runnable in runnables(function):
        yield from _duration((*pointer, "ExecOffset"), runnable.execution_offset)
        yield from _duration((*pointer, "DebounceDelay"), runnable.debounce_delay)


def _duration(pointer: Pointer, text: str | None) -> Problems:
    if text is not None and milliseconds(text) is None:
        yield Problem("F042", pointer, f"{text!r} is no duration.", "Write a number of milliseconds, such as 100.")


# -- scheduling ---------------------------------------------------------------------------------------------------


def _complete_calls(function: FunctionJson) -> Problems:
    for i, component in enumerate(function.components):
        names = [runnable.name for runnable in component.runnables]
        for call in ("Init", "Step", "Terminate"):
            if not any(name.endswith(call) for name in names):
                message = f"Component {component.name!r} has no {call} call: init, step and terminate come together."
                yield Problem("F050", ("ComponentList", i), message, path=component.name)


def _cycles(function: FunctionJson) -> Problems:
    for pointer, _, runnable in runnables(function):
        if runnable.run_type == "Cyclic" and not runnable.cycle_time:
            message = f"{runnable.name} is cyclic, but has no cycle time."
            yield Problem("F051", (*pointer, "Cycletime"), message, path=runnable.name)


def _order(function: FunctionJson) -> Problems:
    hint = Hints()
    placed = {runnable.name: (pointer, runnable) for pointer, _, runnable in runnables(function)}
    before = {name: previous_calls(runnable) for name, (_, runnable) in placed.items()}
    circular = in_circles(before)
    own = function.info.function_name
    for name, (pointer, runnable) in placed.items():
        at = (*pointer, "PrevRunnable")
        for previous in before[name]:
            if previous not in placed:
                if previous.startswith(f"{own}_"):
                    message = f"{name} runs after {previous!r}, which does not exist."
                    yield Problem("F052", at, message, hint(previous, placed), name)
            elif name in circular:
                yield Problem("F053", at, f"{name} runs after itself, by way of {previous}.", path=name)
            elif reason := contradiction(runnable, placed[previous][1]):
                yield Problem("F059", at, f"{name} runs after {previous}, {reason}.", path=name)


def _supervision(function: FunctionJson, known: Collection[str]) -> Problems:
    hint = Hints()
    declared = dict.fromkeys(error.name for _, _, error in errors(function))
    for placed in runnables(function):
        watchdog = placed.runnable.watchdog
        yield from _supervision_types(placed)
        if watchdog is None:
            continue
        pointer = (*placed.pointer, "Watchdog")
        if watchdog.alive:
            yield from _alive((*pointer, "AliveSupervision"), placed.runnable, watchdog.alive)
        if watchdog.deadline:
            yield from _deadline((*pointer, "DeadlineSupervision"), placed.runnable, watchdog.deadline)
        named = (
            ((*pointer, "AliveSupervision", "ErrorName"), watchdog.alive and watchdog.alive.error_name),
            ((*pointer, "DeadlineSupervision", "ErrorName"), watchdog.deadline and watchdog.deadline.error_name),
            ((*pointer, "LogicalError"), watchdog.logical_error),
        )
        for place, name in named:
            if name and name not in declared:
                message = (
                    f"The function does not declare {name!r}, which the supervision of {placed.runnable.name} sets."
                )
                fix = _declared_or_meant(name, declared, known, hint)
                yield Problem("F056", place, message, fix, placed.runnable.name)


def _alive(pointer: Pointer, runnable: Runnable, limits: WatchdogLimits) -> Problems:
    if not limits.min <= limits.reference <= limits.max:
        message = (
            f"Alive limits of {runnable.name}: {limits.min:g} at least, {limits.reference:g} expected, "
            f"{limits.max:g} at most do not ascend."
        )
        yield Problem("F055", pointer, message, path=runnable.name)


def _deadline(pointer: Pointer, runnable: Runnable, limits: WatchdogLimits) -> Problems:
    if limits.min > limits.max:
        message = f"Deadline of {runnable.name}: {limits.min:g} ms at least is more than {limits.max:g} ms at most."
        yield Problem("F055", pointer, message, path=runnable.name)
    elif runnable.cycle_time and limits.max > runnable.cycle_time:
        message = (
            f"The deadline of {runnable.name}, {limits.max:g} ms, lies beyond its cycle, {runnable.cycle_time} ms."
        )
        yield Problem("F054", (*pointer, "Max"), message, path=runnable.name)


def _supervision_types(placed: Placed) -> Problems:
    watchdog = placed.runnable.watchdog
    limits = {
        "Alive": watchdog and watchdog.alive,
        "Deadline": watchdog and watchdog.deadline,
        "Logical": watchdog and watchdog.logical,
    }
    for kind in placed.runnable.supervision_types or ():
        if not limits.get(kind, True):
            message = f"{placed.runnable.name} is under {kind.lower()} supervision, but has no limits for it."
            yield Problem("F058", (*placed.pointer, "SupervisionType"), message, path=placed.runnable.name)


def _asil(function: FunctionJson) -> Problems:
    for pointer, (_, _, runnable), item in data(function):
        level, own = level_of(item.asil_level), level_of(runnable.asil_level)
        if item.role == PROVIDER and is_above(level, own):
            message = f"{runnable.name} is implemented to {own}, but provides {item.name!r} at {level}."
            yield Problem("F057", pointer, message, path=item.name)
    for pointer, (_, _, runnable), error in errors(function):
        level, own = level_of(error.asil_level), level_of(runnable.asil_level)
        if is_above(level, own):
            message = f"{runnable.name} is implemented to {own}, but reports {error.name} at {level}."
            yield Problem("F057", pointer, message, path=error.name)


# -- errors -------------------------------------------------------------------------------------------------------


def _error_references(function: FunctionJson, known: Collection[str]) -> Problems:
    hint = Hints()
    declared = [error.name for _, _, error in errors(function)]
    candidates = dict.fromkeys((*declared, *known))
    for pointer, _, contract in contracts(function):
        for i, reaction in enumerate(contract.safety_reactions or ()):
            for j, name in enumerate(reaction.errors):
                if _is_undeclared(name, candidates, known, function):
                    message = f"{reaction.name} reacts to {name!r}, which nobody declares."
                    place = (*pointer, "SafetyReactionList", i, "ErrorList", j)
                    yield Problem("F060", place, message, hint(name, candidates), reaction.name)
    for pointer, _, error in errors(function):
        for j, name in enumerate(error.dependencies):
            if _is_undeclared(name, candidates, known, function):
                message = f"{error.name} depends on {name!r}, which nobody declares."
                yield Problem("F061", (*pointer, "Dependancy", j), message, hint(name, candidates), error.name)


def _is_undeclared(name: str, candidates: Collection[str], known: Collection[str], function: FunctionJson) -> bool:
    """Errors of others are unknown, and no problem, where no catalogue says what there is."""
    return name not in candidates and (bool(known) or name.startswith(f"{function.info.function_name}_"))


def _dependency_cycles(function: FunctionJson) -> Problems:
    circular = in_circles({error.name: error.dependencies for _, _, error in errors(function)})
    for pointer, _, error in errors(function):
        if error.name in circular:
            message = f"{error.name} depends on itself, by way of {', '.join(error.dependencies)}."
            yield Problem("F062", (*pointer, "Dependancy"), message, path=error.name)


# -- modes and datatypes ------------------------------------------------------------------------------------------


def _modes(function: FunctionJson) -> Problems:
    hint = Hints()
    names = dict.fromkeys(placed.runnable.name for placed in runnables(function))
    last_names = [name.removeprefix(f"{function.info.function_name}_") for name in names]
    allowed = [mode for interface in function.mode_interfaces or () for mode in interface.modes]
    for i, mode in enumerate(function.modes or ()):
        for j, name in enumerate(mode.runnables):
            if name not in names:
                message = f"Mode {mode.name!r} runs {name!r}, which does not exist."
                fix = hint(name, names) or hint(name, last_names)
                yield Problem("F070", ("ModesList", i, "RunnablesList", j), message, fix, mode.name)
        if allowed and mode.name not in allowed:
            message = f"{mode.name!r} is no mode of the mode interfaces."
            fix = hint(mode.name, allowed) or f"They allow {', '.join(dict.fromkeys(allowed))}."
            yield Problem("F071", ("ModesList", i, "Name"), message, fix, mode.name)


def _undefined_types(function: FunctionJson) -> Problems:
    hint = Hints()
    defined = [datatype.reference for datatype in function.datatypes]
    known = frozenset(defined)
    for pointer, reference in references(function):
        if reference not in known:
            message = f"{reference!r} is not among the datatypes of the document."
            yield Problem("F080", pointer, message, hint(reference, defined))


_CHECKS: tuple[Callable[[FunctionJson], Problems], ...] = (
    _calls_twice, _names_twice, _variables_twice, _function_name, _conventional_names, _mode_names, _identifiers, _expressions, _ranges, _durations,
    _complete_calls, _cycles, _order, _asil, _dependency_cycles, _modes, _undefined_types,
)  # fmt: skip
_CHECKS_OF_ERRORS = (_time_outs, _supervision, _error_references)
"""Those that know which errors others declare."""
