"""Modes of a function, and the datatypes of its document."""

from collections.abc import Iterator

from sigcat import codes
from sigcat.function.document.hints import Hints
from sigcat.function.document.problem import Problem, Subject
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.walk import references, runnables

Problems = Iterator[Problem]


def check_modes(function: FunctionJson) -> Problems:
    """Every mode is one of the mode interfaces, and runs calls of the function."""
    hint = Hints()
    names = dict.fromkeys(located.runnable.name for located in runnables(function))
    last_names = [name.removeprefix(f"{function.info.function_name}_") for name in names]
    allowed = dict.fromkeys(mode for interface in function.mode_interfaces or () for mode in interface.modes)
    for i, mode in enumerate(function.modes or ()):
        subject = Subject("mode", mode.name)
        for j, name in enumerate(mode.runnables):
            if name not in names:
                message = f"Mode {mode.name!r} must run calls of the function, not {name!r}, which does not exist."
                at, fix = ("ModesList", i, "RunnablesList", j), hint(name, names) or hint(name, last_names)
                cause = Subject("scheduling", name)
                yield Problem(codes.MODE_RUNS_UNKNOWN_CALL, at, message, fix, subject, cause)
        if allowed and mode.name not in allowed:
            message = f"The mode must be one that the mode interfaces allow, not {mode.name!r}."
            fix = hint(mode.name, allowed) or f"Use one of {', '.join(allowed)}."
            yield Problem(codes.MODE_NOT_IN_INTERFACE, ("ModesList", i, "Name"), message, fix, subject)


def check_types(function: FunctionJson) -> Problems:
    """Every datatype that is referred to is defined."""
    hint = Hints()
    defined = dict.fromkeys(datatype.reference for datatype in function.datatypes)
    for pointer, reference in references(function):
        if reference not in defined:
            message = f"The datatype must be one of the document's `Datatypes`, not {reference!r}."
            yield Problem(codes.TYPE_UNDEFINED, pointer, message, hint(reference, defined))
