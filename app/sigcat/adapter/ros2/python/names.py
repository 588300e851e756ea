"""Names, literals and docstrings in the generated Python."""

import builtins
import keyword
import textwrap
from collections.abc import Iterable, Sequence
from math import isfinite

from sigcat.adapter.core.c.lines import Line, Lines, indented, joined, lines
from sigcat.adapter.core.identifiers import unique
from sigcat.adapter.core.numbers import type_of_c
from sigcat.adapter.core.plan import WireType
from sigcat.function.document.text import Text
from sigcat.function.document.text_filters import AnyText, comment_rows, docstring_text, python_string
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
    """What the classes of a function begin with."""
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


def docstring(summary: str, more: Sequence[AnyText] = ()) -> Lines:
    """A docstring: on one line if it fits, else with its summary on the second one."""
    safe = docstring_text(summary)
    if not more and len(safe) <= WIDEST - 14:
        return (Line(f'"""{safe}"""'),)
    texts = (safe, *map(docstring_text, more))
    parts = [tuple(Line(row) for row in textwrap.wrap(each, WIDEST - 8, break_long_words=False)) for each in texts]
    rows = joined((*part, Line("")) for part in parts)[:-1]
    return (Line('"""'), *rows, Line('"""'))


def commented(text: AnyText) -> Lines:
    """A comment, on as many lines as it needs."""
    return tuple(map(Line, comment_rows(text, "#", WIDEST - 8)))


def suite(head: str, *body: Lines) -> Lines:
    """A statement and what is indented under it."""
    return (Line(head), *indented(joined(body)))


def function(name: str, arguments: Sequence[str], result: str, summary: str, *body: Lines) -> Lines:
    """A method."""
    whole = f"def {name}({', '.join(('self', *arguments))}) -> {result}:"
    head = (
        (Line(whole),)
        if len(whole) <= WIDEST - 4
        else exploded(f"def {name}(", ("self", *arguments), f") -> {result}:")
    )
    return (*head, *indented(joined([docstring(summary) if summary else (), *body])))


def exploded(begin: str, arguments: Iterable[str], end: str = ")") -> Lines:
    """Arguments, one on each line."""
    return (Line(begin), *(Line(f"    {each},") for each in arguments), Line(end))


def call(begin: str, arguments: Sequence[str], end: str = ")") -> Lines:
    """A call: on one line if it fits within a method."""
    whole = f"{begin}{', '.join(arguments)}{end}"
    return (Line(whole),) if len(whole) <= WIDEST - 12 else exploded(begin, arguments, end)


def between(parts: Iterable[Lines], empty: int) -> Lines:
    """Parts with so many empty lines between them."""
    found: list[Line] = []
    for part in parts:
        if part:
            found += [*([Line("")] * (empty if found else 0)), *part]
    return tuple(found)


def written(part: Lines) -> bytes:
    """The text of a module. A line that cannot be broken says so."""
    rows = [row if len(row) <= WIDEST else f"{row}  # noqa: E501" for row in (line.text for line in part)]
    return ("\n".join(rows) + "\n").encode()


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


def _scalar(c: str) -> str:
    kind = type_of_c(c)
    assert kind is not None
    return "bool" if kind.is_boolean else "float" if kind.is_floating else "int"


def sorted_imports(found: Iterable[tuple[str, Iterable[str]]]) -> Lines:
    """Imports in the order of their modules; of one without names, the module itself."""
    ordered = sorted(found, key=lambda each: each[0].lower())
    return joined(imports(module, names) if names else lines(f"import {module}") for module, names in ordered)


def imports(module: str, names: Iterable[str]) -> Lines:
    """An import of what is used, sorted as the linters want it; nothing if nothing is."""
    found = sorted(set(names), key=str.lower)
    if not found:
        return ()
    whole = f"from {module} import {', '.join(found)}"
    return lines(whole) if len(whole) <= WIDEST else exploded(f"from {module} import (", found)
