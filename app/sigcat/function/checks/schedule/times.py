"""Times: an adapter counts them in whole nanoseconds, from 0 to some thirty years."""

from collections.abc import Iterator
from decimal import Decimal

from sigcat import codes
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.function.function_json.duration import LONGEST_MILLISECONDS, milliseconds, whole_nanoseconds
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import errors, runnables, subject_of, timed

_MOST_DIGITS = 30


def check_times(function: FunctionJson) -> Problems:
    """Every time that cannot be counted."""
    for pointer, time, subject in _times(function):
        number = milliseconds(time) if isinstance(time, str) else time
        if number is None:  # its form is checked elsewhere
            continue
        if not 0 <= number <= LONGEST_MILLISECONDS:
            message = f"{_key(pointer, subject)} must be from 0 to {LONGEST_MILLISECONDS:,} ms, not {_plain(time, number)} ms."
            yield Problem(codes.VALUE_UNFIT, pointer, message, subject=subject)
        elif whole_nanoseconds(number) is None:
            message = f"{_key(pointer, subject)} must be whole nanoseconds, not {_plain(time, number)} ms."
            yield Problem(codes.VALUE_UNFIT, pointer, message, "Write at most six decimals.", subject)


def _key(pointer: Pointer, subject: Subject) -> str:
    """The time as the catalogue calls it, or as Function JSON does."""
    return f"`{(*subject.attributes, pointer[-1])[0]}`"


def _plain(time: float | str | None, number: float) -> str:
    """A time as it is written, without an exponent unless it has very many digits."""
    text = time if isinstance(time, str) else f"{Decimal(repr(time)):f}"
    return text if len(text) <= _MOST_DIGITS else repr(number)


def _times(function: FunctionJson) -> Iterator[tuple[Pointer, float | str | None, Subject]]:
    for pointer, _, call in runnables(function):
        attributes = (
            ("Cycletime", call.cycle_time, "cycleTime"),
            ("ExecOffset", call.execution_offset, "executionOffset"),
            ("DebounceDelay", call.debounce_delay, "debounceTime"),
        )
        for key, time, attribute in attributes:
            yield (*pointer, key), time, Subject("scheduling", call.name, (attribute,))
        limits = call.watchdog.deadline if call.watchdog else None
        for key, time in (("Min", limits.min), ("Max", limits.max)) if limits else ():
            at = (*pointer, "Watchdog", "DeadlineSupervision", key)
            yield at, time, Subject("scheduling", call.name, ("deadlineSupervision",))
    for pointer, _, error in errors(function):
        for key, time, attribute in (
            ("MaturationTime", error.maturation_time, "maturationTime"),
            ("ResetTime", error.reset_time, "resetTime"),
        ):
            yield (*pointer, key), time, Subject("error", error.name, (attribute,))
    for pointer, item in timed(function):
        name = (item.vss_path if isinstance(item, Signal | DataQueue) else None) or item.name
        yield (*pointer, "Timeout"), item.timeout, subject_of(item)._replace(name=name)
