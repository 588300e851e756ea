"""Signals, queues and parameters: ranges, start values and timeouts."""

from collections.abc import Collection

from sigcat import codes
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.function.function_json.code import DEFAULT_STORAGE
from sigcat.function.function_json.conversion import is_outside
from sigcat.function.function_json.duration import milliseconds
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, ParameterInterface, Signal
from sigcat.function.function_json.interfaces.role import CONSUMER, PROVIDER
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.runnable import Runnable
from sigcat.function.function_json.triggers import EVENT_TRIGGERED, triggers
from sigcat.function.function_json.walk import data, declared_data, errors, parameters, runnables, subject_of, timed
from sigcat.limits import QUEUE_LENGTH
from sigcat.names import IDENTIFIER, did_you_mean

Item = Signal | DataQueue | ParameterInterface


def check_data_interfaces(function: FunctionJson, known_errors: Collection[str]) -> Problems:
    """Every problem of the data of a function."""
    for pointer, _, item in (*data(function), *parameters(function)):
        yield from _range(pointer, item)
    for pointer, _, item in data(function):
        yield from _replacement(pointer, item)
        yield from _late_value(pointer, item)
        if isinstance(item, DataQueue):
            yield from _queue(pointer, item)
    for pointer, _, item in declared_data(function):
        yield from _optional(pointer, item)
    yield from _keys(function)
    yield from _identifiers(function)
    yield from _durations(function)
    yield from _time_outs(function, known_errors)


def _range(pointer: Pointer, item: Item) -> Problems:
    path = item.vss_path or item.name
    if item.min is not None and item.max is not None and item.min > item.max:
        message = f"`min` of {item.name!r} must be at most `max` ({item.max}), not {item.min}."
        fix, subject = "Exchange `min` and `max`.", Subject("data", path, ("min", "max"))
        yield Problem(codes.RANGE_UPSIDE_DOWN, (*pointer, "Min"), message, fix, subject)
        return
    values = (("InitValue", "init", item.init_value), ("Default", "default", item.default))
    for key, word, value in () if _has_elements(item) else values:
        if value is not None and is_outside(value, item.min, item.max):
            message = f"`{word}` of {item.name!r} must be {_words(item.min, item.max)}, not {value}."
            subject = Subject("data", path, ("default",))
            yield Problem(codes.START_VALUE_OUT_OF_RANGE, (*pointer, key), message, subject=subject, cause=subject)


def _has_elements(item: Item) -> bool:
    """Whether the values of an array or struct stand elsewhere, and 0 in place of them where a number is required."""
    return item.init_elements is not None or (isinstance(item, ParameterInterface) and item.default_text is not None)


def _replacement(pointer: Pointer, item: Signal | DataQueue) -> Problems:
    """Report an unknown replacement for values out of range, and an unknown value after a time-out."""
    for key, action, use in (
        ("RangeErrorAction", item.range_error_action, "replace values out of range"),
        ("TimeoutValue", item.timeout_value, "use after the time-out"),
    ):
        if _is_unknown(action, item):
            what, fix = _REPLACEMENTS[action or ""]
            message = f"{item.name!r} must have {what} to {use}."
            subject = Subject("data", item.vss_path or item.name, ("default",))
            fix = fix.format(f"{key[:1].lower()}{key[1:]}")
            yield Problem(codes.REPLACEMENT_UNKNOWN, (*pointer, key), message, fix, subject)


def _late_value(pointer: Pointer, item: Signal | DataQueue) -> Problems:
    """Report a setting of a time-out that does not exist."""
    for key, value in (
        ("TimeoutStart", item.timeout_start),
        ("TimeoutValue", item.timeout_value),
        ("TimeoutRecovery", item.timeout_recovery),
    ):
        if value is not None and item.timeout is None:
            message = f"{item.name!r} must have a timeout to have `{key[:1].lower()}{key[1:]}`."
            fix = "Give `timeout`, the longest time between two values in ms, or remove it."
            yield Problem(codes.TIMEOUT_ERROR_WITHOUT_TIMEOUT, (*pointer, key), message, fix, subject_of(item))
            return


_REPLACEMENTS = {
    "Default": ("a default", "Give `default` in the catalogue, or write `{}: Init` and `init`."),
    "Init": ("a start value", "Give `init`."),
}


def _is_unknown(replacement: str | None, item: Signal | DataQueue) -> bool:
    """Whether the replacement value is missing. That of a text is in the catalogue alone."""
    has_default, has_init = _is_known(item)
    return not {"Default": has_default, "Init": has_init}.get(replacement or "", True)


def _is_known(item: Signal | DataQueue) -> tuple[bool, bool]:
    """Whether the default and the start value are known. Those of a text are in the catalogue alone."""
    is_text = (item.vss_datatype or "").endswith(("string", "string[]"))
    default, init = (item.default, item.default_elements), (item.init_value, item.init_elements)
    return is_text or default != (None, None), is_text or init != (None, None)


# -- optional signals ---------------------------------------------------------------------------------------------


def _optional(pointer: Pointer, item: Signal | DataQueue) -> Problems:
    """Report an optional signal without a start value, and an error for the absence of one that is not optional."""
    subject = Subject("data", item.vss_path or item.name, ("default",))
    is_consumed = item.role == CONSUMER
    if item.is_optional and is_consumed and isinstance(item, Signal) and not any(_is_known(item)):
        message = f"{item.name!r} must have a start value: it is 0 in a vehicle without the signal."
        yield Problem(codes.OPTIONAL_WITHOUT_START_VALUE, pointer, message, "Give `init`.", subject)
    if item.absent_error and not (item.is_optional and is_consumed):
        message = f"`absentError` needs a consumed signal with `optional: true`; {item.name!r} is {'not optional' if is_consumed else 'provided'}."
        fix = "Add `optional: true`, or remove `absentError`." if is_consumed else "Remove `absentError`."
        yield Problem(codes.ABSENT_ERROR_WITHOUT_OPTIONAL, (*pointer, "AbsentError"), message, fix, subject)


# -- queues and stored values -------------------------------------------------------------------------------------


def _queue(pointer: Pointer, item: DataQueue) -> Problems:
    """As many values at once as the queue has, into an array, with a place for their number."""
    count, subject = item.values_per_step or 1, Subject("data", item.vss_path or item.name)
    at = (*pointer, "ValuesPerStep")
    if item.queue_length > QUEUE_LENGTH:
        message = f"The queue of {item.name!r} must hold at most {QUEUE_LENGTH:,} values, not {item.queue_length:,}."
        fix = "Shorten it: the core has a place for each."
        yield Problem(codes.QUEUE_UNFIT, (*pointer, "QueueLength"), message, fix, subject)
    if count > item.queue_length:
        most = item.queue_length
        message = f"{item.name!r} must take at most {most} values at once, which its queue holds, not {count}."
        fix = "Lengthen the queue, or take fewer values."
        yield Problem(codes.QUEUE_UNFIT, at, message, fix, subject)
    if count > 1 and not (item.variable and item.count_variable):
        lacking = "countVariable" if item.variable else "variable"
        message = f"{item.name!r} must have `{lacking}` to take {count} values at once."
        fix = "Name the array that takes the values as `variable`, and what takes their number as `countVariable`."
        yield Problem(codes.QUEUE_UNFIT, at, message, fix, subject)


def _keys(function: FunctionJson) -> Problems:
    """A key holds one parameter: two calls may use the same one, but not two different ones, nor is case enough for two."""
    default = (function.code.storage if function.code else None) or DEFAULT_STORAGE
    holders: dict[tuple[str, str], str] = {}
    for pointer, _, item in parameters(function):
        storage, key, held = item.storage or default, item.key or item.name, item.vss_path or item.name
        holder = holders.setdefault((storage.lower(), key.lower()), held)
        if holder != held:
            message = f"The key {key!r} of the storage {storage!r} holds {holder!r} and {held!r}."
            fix, subject = "Give each its own `key`.", Subject("data", held)
            yield Problem(codes.KEY_USED_TWICE, (*pointer, "Key"), message, fix, subject)


def _identifiers(function: FunctionJson) -> Problems:
    """Report names that are not identifiers; a parameter's own name becomes one by itself."""
    yield from _identifier(("Code", "Storage"), function.code.storage if function.code else None, None)
    for pointer, _, item in parameters(function):
        subject = Subject("data", item.vss_path or item.name)
        yield from _identifier((*pointer, "Key"), item.key, subject)
        yield from _identifier((*pointer, "Storage"), item.storage, subject)


def _identifier(at: Pointer, text: str | None, owner: Subject | None) -> Problems:
    if text is not None and not IDENTIFIER.fullmatch(text):
        what = f"A {str(at[-1]).lower()}"
        message = f"{what} must be at most 128 letters, digits and underscores, a letter first, not {text[:60]!r}."
        yield Problem(codes.KEY_NO_IDENTIFIER, at, message, "Rename it.", owner)


def _words(low: float | None, high: float | None) -> str:
    """A range as text: `0 or more`, `0 to 255`."""
    if low is None or high is None:
        return f"{low} or more" if low is not None else f"{high} or less"
    return f"{low} to {high}"


# -- timeouts ----------------------------------------------------------------------------------------------------


def _time_outs(function: FunctionJson, known: Collection[str]) -> Problems:
    declared = dict.fromkeys(error.name for _, _, error in errors(function))
    for pointer, (_, _, runnable), item in data(function):
        subject = Subject("data", item.name)
        yield from _time_out(pointer, runnable, item, subject)
        if item.role == PROVIDER and item.external_provider is not None:
            message = f"A provider must be that of a consumed signal; {item.name!r} is provided."
            fix = "Remove it, or write `role: consumed`."
            yield Problem(codes.TIMEOUT_OF_PROVIDED, (*pointer, "ExternalProvider"), message, fix, subject)
        name = item.timeout_error
        if name and name not in declared:
            message = f"The timeout error of {item.name!r} must be one that the function declares, not {name!r}."
            fix = declared_or_meant(name, declared, known)
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
        fix = "Make it at least the cycle time. The call reads once in each cycle, so a shorter timeout always expires."
        yield Problem(codes.TIMEOUT_SHORTER_THAN_CYCLE, (*pointer, "Timeout"), message, fix, subject)
    elif duration is not None and _is_only_trigger(item, runnable):
        what = f"The timeout of {item.name!r}"
        message = f"{what} must be that of a call which runs without it; {runnable.name} waits for it."
        fix = "Have a cyclic call consume the signal with the timeout, or let another signal trigger this call too."
        yield Problem(codes.TIMEOUT_OF_ONLY_TRIGGER, (*pointer, "Timeout"), message, fix, subject)
    if item.timeout_error and duration is None and item.timeout is None:
        message = f"{item.name!r} has the timeout error {item.timeout_error!r}, but no timeout that would set it."
        fix = "Give `timeout`, the longest time between two values in ms, or remove the error."
        yield Problem(codes.TIMEOUT_ERROR_WITHOUT_TIMEOUT, (*pointer, "TimeoutError"), message, fix, subject)


def _is_only_trigger(item: Signal | DataQueue, runnable: Runnable) -> bool:
    """Whether a call runs on the values of one signal, and on nothing else."""
    if runnable.run_type != EVENT_TRIGGERED:
        return False
    keys = {each.vss_path or each.name for each in triggers(runnable)}
    return keys == {item.vss_path or item.name}


def declared_or_meant(name: str, declared: Collection[str], known: Collection[str]) -> str:
    """Return a fix for an error that no call declares: one that exists was not mistyped."""
    return (name not in known and did_you_mean(name, declared)) or "Add it to the errors of the call."


def _durations(function: FunctionJson) -> Problems:
    for pointer, item in timed(function):
        yield from _duration((*pointer, "Timeout"), item.timeout)
    for pointer, _, runnable in runnables(function):
        yield from _duration((*pointer, "ExecOffset"), runnable.execution_offset)
        yield from _duration((*pointer, "DebounceDelay"), runnable.debounce_delay)


def _duration(pointer: Pointer, text: str | None) -> Problems:
    if text is not None and milliseconds(text) is None:
        message = f"`{pointer[-1]}` must be a duration, not {text!r}."
        yield Problem(codes.TEXT_NO_DURATION, pointer, message, "Write a number of milliseconds, such as 100.")
