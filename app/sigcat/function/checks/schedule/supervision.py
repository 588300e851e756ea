"""Supervision of calls by the watchdog: its limits, and the errors that it sets."""

from collections.abc import Collection, Iterator

from sigcat import codes
from sigcat.function.checks.data_interfaces import declared_or_meant
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.runnable import Runnable, Watchdog, WatchdogLimits
from sigcat.function.function_json.walk import Located, errors, runnables


def check_supervision(function: FunctionJson, known_errors: Collection[str]) -> Problems:
    """Every problem of the supervision of calls. `known_errors` are names of errors that others declare."""
    declared = dict.fromkeys(error.name for _, _, error in errors(function))
    for located in runnables(function):
        watchdog, pointer = located.runnable.watchdog, (*located.pointer, "Watchdog")
        yield from _types(located)
        if watchdog is None:
            continue
        if watchdog.alive:
            yield from _alive((*pointer, "AliveSupervision"), located.runnable, watchdog.alive)
        if watchdog.deadline:
            yield from _deadline((*pointer, "DeadlineSupervision"), located.runnable, watchdog.deadline)
        for at, attribute, name in _errors(pointer, watchdog):
            if name and name not in declared:
                call = located.runnable.name
                what = f"The error of the supervision of {call}"
                message = f"{what} must be one that the function declares, not {name!r}."
                fix = declared_or_meant(name, declared, known_errors)
                subject, cause = Subject("scheduling", call, (attribute,)), Subject("error", name)
                yield Problem(codes.SUPERVISION_ERROR_UNDECLARED, at, message, fix, subject, cause)


def _errors(pointer: Pointer, watchdog: Watchdog) -> Iterator[tuple[Pointer, str, str | None]]:
    """The errors that the watchdog sets, each with its pointer and the attribute of the catalogue that names it."""
    for kind, limits in (("Alive", watchdog.alive), ("Deadline", watchdog.deadline)):
        if limits:
            yield (*pointer, f"{kind}Supervision", "ErrorName"), f"{kind.lower()}Supervision", limits.error_name
    yield (*pointer, "LogicalError"), "logicalSupervision", watchdog.logical_error


def _alive(pointer: Pointer, runnable: Runnable, limits: WatchdogLimits) -> Problems:
    if not limits.min <= limits.reference <= limits.max:
        message = (
            f"Alive limits of {runnable.name} must be min ≤ reference ≤ max; "
            f"got {limits.min:g}, {limits.reference:g}, {limits.max:g}."
        )
        subject = Subject("scheduling", runnable.name, ("aliveSupervision",))
        yield Problem(codes.SUPERVISION_LIMITS_UPSIDE_DOWN, pointer, message, subject=subject)


def _deadline(pointer: Pointer, runnable: Runnable, limits: WatchdogLimits) -> Problems:
    subject = Subject("scheduling", runnable.name, ("deadlineSupervision", "cycleTime"))
    if limits.min > limits.max:
        message = f"Deadline limits of {runnable.name} must be min ≤ max; got {limits.min:g} ms and {limits.max:g} ms."
        yield Problem(codes.SUPERVISION_LIMITS_UPSIDE_DOWN, pointer, message, subject=subject)
    elif runnable.cycle_time and limits.max > runnable.cycle_time:
        message = f"The deadline of {runnable.name} must lie within its cycle, {runnable.cycle_time} ms; got {limits.max:g} ms."
        yield Problem(codes.DEADLINE_BEYOND_CYCLE, (*pointer, "Max"), message, subject=subject)


def _types(located: Located) -> Problems:
    name, watchdog = located.runnable.name, located.runnable.watchdog
    limits = {
        "Alive": watchdog and watchdog.alive,
        "Deadline": watchdog and watchdog.deadline,
        "Logical": watchdog and watchdog.logical,
    }
    for kind in located.runnable.supervision_types or ():
        if not limits.get(kind, True):
            message = f"{name} is under {kind.lower()} supervision, but has no limits for it."
            at, attribute = (*located.pointer, "SupervisionType"), f"{kind.lower()}Supervision"
            subject = Subject("scheduling", name, (attribute,))
            yield Problem(codes.SUPERVISION_WITHOUT_LIMITS, at, message, subject=subject)
