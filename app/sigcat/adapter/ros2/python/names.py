"""Names, literals and imports in the generated Python."""

import builtins
import keyword
from collections.abc import Iterable, Sequence
from math import isfinite
from typing import NamedTuple

from sigcat.adapter.core.identifiers import unique
from sigcat.adapter.core.numbers import type_of_c
from sigcat.adapter.core.plan import WireType
from sigcat.function.document.text import Text
from sigcat.function.document.text_filters import python_string
from sigcat.names import camel_case, snake_case

WIDEST = 99
"""Columns of a line, as the linters of ROS 2 count."""
_TAKEN = frozenset((*dir(builtins), "count", "index", "self", "message", "t", "value", "stamp"))


def python_names(names: Iterable[str]) -> dict[str, str]:
    """Names of the library as those of members in Python: `AccReq` → `acc_req`."""
    found: dict[str, str] = {}
    for name in names:
        text = snake_case(name) or "value"
        found[name] = unique(f"{text}_" if keyword.iskeyword(text) or text in _TAKEN else text, found.values())
    return found


def class_name(function: str) -> str:
    """Prefix of the classes of a function."""
    return camel_case(function)


def number(value: object) -> str:
    """A number, or a list of numbers or texts, as a literal."""
    if isinstance(value, list | tuple):
        return f"[{', '.join(number(each) for each in value)}]"
    return (
        python_string(value) if isinstance(value, Text) else _float(value) if isinstance(value, float) else repr(value)
    )


def _float(value: float) -> str:
    return repr(value) if isfinite(value) else f"float({python_string(str(value))})"


def written(module: str) -> bytes:
    """The bytes of a module. A line that cannot be broken says so."""
    rows = (row if len(row) <= WIDEST else f"{row}  # noqa: E501" for row in module.split("\n"))
    return "\n".join(rows).encode()


def typed(wire: WireType, *, is_sequence: bool = False) -> str:
    """The type of a value in Python. `is_sequence`: what is given may be any sequence."""
    one = (
        "Mapping[str, Any]"
        if wire.is_struct and is_sequence
        else "Dict[str, Any]"
        if wire.is_struct
        else _scalar(wire.c)
    )
    if wire.length is None:
        return one
    return f"Sequence[{one}]" if is_sequence else f"List[{one}]"


def typing_names(wire: WireType, *, is_sequence: bool = False) -> set[str]:
    """Names of `typing` in this type."""
    mapping, listed = ("Mapping", "Sequence") if is_sequence else ("Dict", "List")
    return {*((mapping, "Any") if wire.is_struct else ()), *(() if wire.length is None else (listed,))}


def _scalar(c: str) -> str:
    kind = type_of_c(c)
    assert kind is not None
    return "bool" if kind.is_boolean else "float" if kind.is_floating else "int"


class Import(NamedTuple):
    """An import of names from a module; of the module itself without any."""

    module: str
    names: Sequence[str]


def imports(found: Iterable[tuple[str, Iterable[str]]]) -> Sequence[Import]:
    """Imports in the order of their modules and names, as the linters require."""
    ordered = sorted(found, key=lambda each: each[0].lower())
    return [Import(module, sorted(set(names), key=str.lower)) for module, names in ordered]
