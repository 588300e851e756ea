"""Calls of a function: complete, in an order that can be kept, and implemented to the ASIL of what they provide."""

from collections.abc import Iterator

from sigcat import codes
from sigcat.asil import is_above, level_of
from sigcat.function.checks.circles import circles
from sigcat.function.checks.order import contradiction, previous_calls
from sigcat.function.document.hints import Hints
from sigcat.function.document.problem import Problem, Subject
from sigcat.function.function_json.model import PROVIDER, FunctionJson
from sigcat.function.function_json.walk import Located, data, errors, runnables
from sigcat.names import either

Problems = Iterator[Problem]


def check_calls(function: FunctionJson) -> Problems:
    """Every problem of calls, but for their supervision."""
    yield from _complete(function)
    yield from _cycles(function)
    yield from _order(function)
    yield from _asil(function)


_COMPLETE = ("Init", "Step", "Terminate")


def _complete(function: FunctionJson) -> Problems:
    for i, component in enumerate(function.components):
        subject = Subject("component", component.name)
        names = [runnable.name for runnable in component.runnables]
        lacking = [call for call in _COMPLETE if not any(name.endswith(call) for name in names)]
        if lacking:
            message = f"Component {component.name!r} must have an Init, a Step and a Terminate call; it has no {either(lacking)}."
            yield Problem(codes.CALLS_INCOMPLETE, ("ComponentList", i), message, "", subject, cause=subject)


def _cycles(function: FunctionJson) -> Problems:
    for pointer, _, runnable in runnables(function):
        if runnable.run_type == "Cyclic" and not runnable.cycle_time:
            message = f"{runnable.name} is cyclic, but has no cycle time."
            subject = Subject("scheduling", runnable.name, ("cycleTime",))
            yield Problem(codes.CYCLIC_CALL_WITHOUT_CYCLE, (*pointer, "Cycletime"), message, subject=subject)


def _order(function: FunctionJson) -> Problems:
    hint = Hints()
    by_name = {located.runnable.name: located for located in runnables(function)}
    before = {name: previous_calls(located.runnable) for name, located in by_name.items()}
    circle_of = circles(before, "scheduling", "previousRunnable")
    for name, located in by_name.items():
        at, subject = (*located.pointer, "PrevRunnable"), Subject("scheduling", name, ("previousRunnable",))
        for previous in before[name]:
            if previous not in by_name:
                yield from _unknown_previous(previous, located, by_name, function, hint)
            elif name in circle_of and circle_of.get(previous) is circle_of[name]:
                message = f"{name} depends on itself: it runs after {previous}, and that after it."
                circle = circle_of[name]
                yield Problem(codes.PREVIOUS_CALLS_IN_A_CIRCLE, at, message, subject=subject, circle=circle)
            elif reason := contradiction(located.runnable, by_name[previous].runnable):
                message = f"{name} runs after {previous}, {reason}."
                yield Problem(codes.ORDER_CONTRADICTS_PRIORITY, at, message, subject=subject)


def _unknown_previous(
    previous: str, located: Located, by_name: dict[str, Located], function: FunctionJson, hint: Hints
) -> Problems:
    """Calls of other functions are not known here."""
    if previous.startswith(f"{function.info.function_name}_"):
        name = located.runnable.name
        message = f"{name} must run after a call of the function, not after {previous!r}, which does not exist."
        at, fix = (*located.pointer, "PrevRunnable"), hint(previous, by_name)
        subject, cause = Subject("scheduling", name, ("previousRunnable",)), Subject("scheduling", previous)
        yield Problem(codes.PREVIOUS_CALL_UNKNOWN, at, message, fix, subject, cause)


def _asil(function: FunctionJson) -> Problems:
    for pointer, (_, _, runnable), item in data(function):
        level, own = level_of(item.asil_level), level_of(runnable.asil_level)
        if item.role == PROVIDER and is_above(level, own):
            message = f"{runnable.name} must be implemented to {level}, not {own}: it provides {item.name!r}."
            yield Problem(codes.ASIL_OF_CALL_TOO_LOW, pointer, message, subject=Subject("data", item.name))
    for pointer, (_, _, runnable), error in errors(function):
        level, own = level_of(error.asil_level), level_of(runnable.asil_level)
        if is_above(level, own):
            message = f"{runnable.name} must be implemented to {level}, not {own}: it reports {error.name}."
            yield Problem(codes.ASIL_OF_CALL_TOO_LOW, pointer, message, subject=Subject("error", error.name))
