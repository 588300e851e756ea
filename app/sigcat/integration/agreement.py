"""Names in an Integration JSON that the functions it carries must have."""

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from pydantic import BaseModel

from sigcat.function.document.document import Pointer
from sigcat.function.document.unfit_texts import StringField, string_fields, titled
from sigcat.function.function_json import walk
from sigcat.function.function_json.model import FunctionJson
from sigcat.integration.problem import Problem
from sigcat.names import did_you_mean

Names = Mapping[str, frozenset[str]]
"""Names by what they are of: `call`, `method`."""


def missing_names(model: BaseModel, functions: Sequence[FunctionJson]) -> Iterator[Problem]:
    """Every name of a document that its functions do not have; below the name of a function, those that it does not have."""
    of_each = {function.info.function_name: _names(function) for function in functions}
    of_all = {"function": frozenset(of_each)}
    for kind in next(iter(of_each.values()), {}):
        of_all[kind] = frozenset(name for names in of_each.values() for name in names[kind])
    yield from _in_model(model, of_all, of_each, of_all, ())


def _names(function: FunctionJson) -> Names:
    named = {
        "component": {each.name for each in function.components},
        "call": {each.runnable.name for each in walk.runnables(function)},
        "method": {each.name for _, _, each in walk.methods(function)},
        "parameter": {each.name for _, _, each in walk.parameters(function)},
        "error": {name for _, _, each in walk.errors(function) for name in (each.name, *each.dependencies)},
    }
    statuses = {name for _, _, each in walk.safety_reactions(function) for name in (each.name, *each.errors)}
    statuses |= {each.name for each in function.mode_interfaces or ()}
    named["error"] |= {name for name in statuses if name.endswith("_ErrorSts")}
    signals = {each.name for _, _, each in walk.data(function)}
    named["interface"] = signals | statuses | named["method"] | named["parameter"] | named["error"]
    return {kind: frozenset(names) for kind, names in named.items()}


def _in_model(
    model: BaseModel, known: Names, of_each: Mapping[str, Names], of_all: Names, at: Pointer
) -> Iterator[Problem]:
    fields = string_fields(type(model))
    for field in fields:
        value = getattr(model, field.name)
        if field.refers is not None and field.refers.to == "function" and isinstance(value, str):
            known = {**of_each.get(value, of_all), "function": of_all["function"]}
    for field in fields:
        if field.alias != "SourceFunctionList":
            yield from _in_value(getattr(model, field.name), field, known, of_each, of_all, (*at, field.alias))


def _in_value(
    value: Any, field: StringField, known: Names, of_each: Mapping[str, Names], of_all: Names, at: Pointer
) -> Iterator[Problem]:
    if isinstance(value, BaseModel):
        yield from _in_model(value, known, of_each, of_all, at)
    elif isinstance(value, tuple):
        for index, item in enumerate(value):
            yield from _in_value(item, field, known, of_each, of_all, (*at, index))
    elif isinstance(value, str) and field.refers is not None:
        kind = field.refers.to
        if value not in known[kind]:
            article = "an" if kind[0] in "aeiou" else "a"
            message = (
                f"{titled(at)} must be {article} {kind} of the functions in `SourceFunctionList`, not {value[:80]!r}."
            )
            yield Problem(at, message, did_you_mean(value, known[kind]) or "Integrate the functions again.")


def argument_counts(functions: Sequence[FunctionJson]) -> Mapping[str, frozenset[tuple[int, int]]]:
    """Numbers of arguments and results of methods, by name."""
    found: dict[str, frozenset[tuple[int, int]]] = {}
    for function in functions:
        for _, _, method in walk.methods(function):
            counts = (len(method.inputs), len(method.outputs))
            found[method.name] = found.get(method.name, frozenset()) | {counts}
    return found
