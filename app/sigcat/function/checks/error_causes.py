"""Causes of errors beside time-outs and supervision, their resets, and contradictions between calls."""

from collections.abc import Collection, Iterator

from sigcat import codes
from sigcat.function.checks.data_interfaces import declared_or_meant
from sigcat.function.declaration.form import key_of
from sigcat.function.document.document import Pointer
from sigcat.function.document.problem import Problem, Problems, Subject
from sigcat.function.function_json.datatypes.datatype import Datatype, innermost
from sigcat.function.function_json.datatypes.primitive_types import c_type
from sigcat.function.function_json.error_fields import errors_set_by
from sigcat.function.function_json.interfaces.data_interfaces import DataQueue, Signal
from sigcat.function.function_json.interfaces.role import CONSUMER, PROVIDER
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import (
    data,
    declared_data,
    errors,
    modes,
    parameters,
    runnables,
    statuses,
    subject_of,
)
from sigcat.names import did_you_mean

RESTART = "Restart"


def check_error_causes(function: FunctionJson, known_errors: Collection[str]) -> Problems:
    """Every problem of them. `known_errors` are names of errors that others declare."""
    yield from _undeclared(function, known_errors)
    yield from _never_set(function)
    yield from _never_found(function)
    yield from _resets(function)
    yield from _listed_differently(function)


def _causes(function: FunctionJson) -> Iterator[tuple[Pointer, str, Subject]]:
    """Errors that are named, each with its pointer and what names it."""
    for pointer, _, item in (*declared_data(function), *parameters(function)):
        for each in errors_set_by(item):
            if each.field != "timeout_error":  # a separate rule has it
                yield (*pointer, each.key), each.error, subject_of(item)
    for pointer, _, call in runnables(function):
        subject = Subject("scheduling", call.name)
        yield from (((*pointer, each.key), each.error, subject) for each in errors_set_by(call))
    for pointer, mode in modes(function):
        yield from (((*pointer, each.key), each.error, subject_of(mode)) for each in errors_set_by(mode))


def _undeclared(function: FunctionJson, known: Collection[str]) -> Problems:
    declared = dict.fromkeys(error.name for _, _, error in errors(function))
    for pointer, name, subject in _causes(function):
        if name not in declared:
            key = str(pointer[-1])
            what = f"`{key[:1].lower()}{key[1:]}` of {subject.name!r}"
            message = f"{what} must be an error that the function declares, not {name!r}."
            fix = declared_or_meant(name, declared, known)
            yield Problem(codes.SET_ERROR_UNDECLARED, pointer, message, fix, subject, Subject("error", name))


def _never_set(function: FunctionJson) -> Problems:
    """Range errors of values without a range: an enumeration has one, and so has a struct with its own ranges."""
    types = {datatype.reference: datatype for datatype in function.datatypes}
    for pointer, _, item in (*data(function), *parameters(function)):
        kind = innermost(item.datatype, types)
        is_bounded = item.min is not None or item.max is not None or (kind is not None and kind.kind is not None)
        if item.range_error and not is_bounded:
            message = f"{item.name!r} must have a range to have a range error."
            at, fix = (*pointer, "RangeError"), "Give `min` and `max`, or remove `rangeError`."
            yield Problem(codes.RANGE_ERROR_WITHOUT_RANGE, at, message, fix, subject_of(item))


def _never_found(function: FunctionJson) -> Problems:
    """Errors of provided data that only its consumers can find."""
    for pointer, _, item in data(function):
        for each in errors_set_by(item):
            if item.role == PROVIDER and each.mark.is_of_consumer:
                message = f"`{key_of(each.field)}` must be that of a consumed signal; {item.name!r} is provided."
                fix = "Remove it: the calls that consume the signal check its messages."
                yield Problem(codes.E2E_ERROR_OF_PROVIDED, (*pointer, each.key), message, fix, subject_of(item))


# -- resets -------------------------------------------------------------------------------------------------------


def _resets(function: FunctionJson) -> Problems:
    types = {datatype.reference: datatype for datatype in function.datatypes}
    consumed = {item.name: item for _, _, item in declared_data(function) if item.role == CONSUMER}
    for pointer, _, error in errors(function):
        if error.reset is None or error.reset == RESTART:
            continue
        subject, signal = Subject("error", error.name), consumed.get(error.reset)
        if signal is None:
            message = f"`reset` of {error.name} must be a signal that the function consumes, or `restart`, not {error.reset!r}."
            meant = did_you_mean(error.reset, (*consumed, "restart"))
            fix = meant or "List the signal under the data of a call, as consumed."
            yield Problem(codes.RESET_UNKNOWN, (*pointer, "Reset"), message, fix, subject)
        elif not _is_condition(signal, types):
            message = (
                f"{error.name} must be reset by a boolean or an integer, not by {error.reset!r}, which is neither."
            )
            yield Problem(codes.RESET_UNKNOWN, (*pointer, "Reset"), message, "Name another signal.", subject)


def _is_condition(signal: Signal | DataQueue, types: dict[str, Datatype]) -> bool:
    datatype = types.get(signal.datatype)
    meant = c_type(datatype.c_definition) if datatype and datatype.kind in (None, "enumeration") else None
    return meant is not None and meant.kind in ("boolean", "unsigned", "signed")


# -- the same one at several calls --------------------------------------------------------------------------------

_COMPARED = {
    "error": ("variable", "status_variable", "defined_by", "reset", "occurrence_count_limit", "ignition_count_limit"),
    "safety_reaction": ("variable", "defined_by", "initial", "timeout"),
}


def _listed_differently(function: FunctionJson) -> Problems:
    """An error is one, whichever calls list it, and so is a reaction."""
    first: dict[str, tuple[object, ...]] = {}
    for pointer, _, each in statuses(function):
        subject = subject_of(each)
        values = tuple(getattr(each, field) for field in _COMPARED[subject.kind])
        if any(values) and first.setdefault(each.name, values) != values:
            message = f"{each.name} must be described alike at every call that lists it."
            fix = "Describe it at one call, and list its name alone at the others."
            yield Problem(codes.LISTED_DIFFERENTLY, pointer, message, fix, subject)
