"""Several functions as one set: datatypes of one name and two meanings get two names."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple

from sigcat.function.function_json.datatypes.datatype import Datatype
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.resolved_function import ResolvedFunction

_REFERENCES = ("Datatype", "ElementType", "typeRef")


class FunctionSet(NamedTuple):
    """Functions whose references all mean one table of datatypes."""

    functions: tuple[ResolvedFunction, ...]
    datatypes: tuple[Datatype, ...]


def function_set(functions: Sequence[ResolvedFunction]) -> FunctionSet:
    """Merge the datatypes of functions. The first function keeps its names."""
    table: dict[str, Datatype] = {}
    merged = []
    for resolved in functions:
        function = resolved.function
        names = {datatype.reference: _free(datatype, table) for datatype in function.datatypes}
        changed = {old: new for old, new in names.items() if old != new}
        own = FunctionJson.model_validate(_renamed(function.model_dump(), changed)) if changed else function
        table.update((datatype.reference, datatype) for datatype in own.datatypes)
        merged.append(replace(resolved, function=own))
    return FunctionSet(tuple(merged), tuple(table.values()))


def _free(datatype: Datatype, table: dict[str, Datatype]) -> str:
    name, number = datatype.reference, 1
    while name in table and table[name] != datatype.model_copy(update={"reference": name}):
        number += 1
        name = f"{datatype.reference}V{number}"
    return name


def _renamed(value: Any, names: dict[str, str]) -> Any:
    if isinstance(value, dict):
        return {
            key: names.get(item, item) if key in _REFERENCES and isinstance(item, str) else _renamed(item, names)
            for key, item in value.items()
        }
    return [_renamed(item, names) for item in value] if isinstance(value, list | tuple) else value
