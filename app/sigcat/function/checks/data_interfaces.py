"""Signals, queues and parameters: ranges, start values and timeouts."""

from collections.abc import Collection, Iterator

from sigcat import codes
from sigcat.function.document.document import Pointer
from sigcat.function.document.hints import Hints
from sigcat.function.document.problem import Problem, Subject
from sigcat.function.function_json.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.duration import milliseconds
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.role import PROVIDER
from sigcat.function.function_json.runnable import Runnable
from sigcat.function.function_json.walk import data, errors, parameters, runnables

Problems = Iterator[Problem]
Item = Signal | DataQueue | ParameterInterface


def check_data_interfaces(function: FunctionJson, known_errors: Collection[str]) -> Problems:
    """Every problem of the data of a function."""
    for pointer, _, item in (*data(function), *parameters(function)):
        yield from _range(pointer, item)
    for pointer, _, item in data(function):
        yield from _replacement(pointer, item)
    yield from _durations(function)
    yield from _time_outs(function, known_errors)


def _range(pointer: Pointer, item: Item) -> Problems:
    path = item.vss_path or item.name
    if item.min is not None and item.max is not None and item.min > item.max:
        message = f"The range of {item.name!r} must ascend, not run from {item.min} to {item.max}."
        fix, subject = "Exchange `min` and `max`.", Subject("data", path, ("min", "max"))
        yield Problem(codes.RANGE_UPSIDE_DOWN, (*pointer, "Min"), message, fix, subject)
        return
    for key, value in (("InitValue", item.init_value), ("Default", getattr(item, "default", None))):
        if value is not None and _is_outside(value, item.min, item.max):
            message = f"`{key}` of {item.name!r} must be {_words(item.min, item.max)}, not {value}."
            subject = Subject("data", path, ("default",))
            yield Problem(codes.START_VALUE_OUT_OF_RANGE, (*pointer, key), message, subject=subject, cause=subject)


def _replacement(pointer: Pointer, item: Signal | DataQueue) -> Problems:
    """What is to replace a value out of range has to be known. Texts and arrays stand in the catalogue alone."""
    action = item.range_error_action
    known = {"Default": item.default, "Init": item.init_value}.get(action or "", 0)
    if known is None and not (item.vss_datatype or "").endswith(("string", "[]")):
        what, fix = _REPLACEMENTS[action or ""]
        message = f"{item.name!r} must have {what} to replace values out of range."
        subject = Subject("data", item.vss_path or item.name, ("default",))
        yield Problem(codes.REPLACEMENT_UNKNOWN, (*pointer, "RangeErrorAction"), message, fix, subject)


_REPLACEMENTS = {
    "Default": ("a default", "Give `default` in the catalogue, or write `rangeErrorAction: Init` and `init`."),
    "Init": ("a start value", "Give `init`."),
}


def _is_outside(value: float, low: float | None, high: float | None) -> bool:
    return (low is not None and value < low) or (high is not None and value > high)


def _words(low: float | None, high: float | None) -> str:
    """A range in words: `0 or more`, `0 to 255`."""
    if low is None or high is None:
        return f"{low} or more" if low is not None else f"{high} or less"
    return f"{low} to {high}"


# -- timeouts ----------------------------------------------------------------------------------------------------


def _time_outs(function: FunctionJson, known: Collection[str]) -> Problems:
    hint = Hints()
    declared = dict.fromkeys(error.name for _, _, error in errors(function))
    for pointer, (_, _, runnable), item in data(function):
        subject = Subject("data", item.name)
        yield from _time_out(pointer, runnable, item, subject)
        name = item.timeout_error
        if name and name not in declared:
            message = f"The timeout error of {item.name!r} must be one that the function declares, not {name!r}."
            fix = declared_or_meant(name, declared, known, hint)
            cause = Subject("error", name)
            yield Problem(codes.TIMEOUT_ERROR_UNDECLARED, (*pointer, "TimeoutError"), message, fix, subject, cause)


def _time_out(pointer: Pointer, runnable: Runnable, item: Signal | DataQueue, subject: Subject) -> Problems:
    duration = milliseconds(item.timeout)
    if item.role == PROVIDER and item.timeout is not None:
        message = f"A timeout must be that of a consumed signal; {item.name!r} is provided."
        fix = "Remove it: the calls that consume the signal wait for it."
        yield Problem(codes.TIMEOUT_OF_PROVIDED, (*pointer, "Timeout"), message, fix, subject)
    elif duration is not None and runnable.cycle_time and duration < runnable.cycle_time:
        message = f"The timeout of {item.name!r} must not be shorter than the cycle, {runnable.cycle_time} ms; got {duration:g} ms."
        fix = "Make it at least the cycle time: it would pass before the value can be looked at twice."
        yield Problem(codes.TIMEOUT_SHORTER_THAN_CYCLE, (*pointer, "Timeout"), message, fix, subject)
    if item.timeout_error and duration is None and item.timeout is None:
        message = f"{item.name!r} has the timeout error {item.timeout_error!r}, but no timeout that would set it."
        fix = "Give `timeout`, the longest time between two values in ms, or remove the error."
        yield Problem(codes.TIMEOUT_ERROR_WITHOUT_TIMEOUT, (*pointer, "TimeoutError"), message, fix, subject)


def declared_or_meant(name: str, declared: Collection[str], known: Collection[str], hint: Hints) -> str:
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
        message = f"`{pointer[-1]}` must be a duration, not {text!r}."
        yield Problem(codes.TEXT_NO_DURATION, pointer, message, "Write a number of milliseconds, such as 100.")
