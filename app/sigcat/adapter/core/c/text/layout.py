"""Lines of C from the templates: indented by their braces if not further, with few empty lines."""

import re
from collections.abc import Iterable, Iterator
from typing import Any

from sigcat.adapter.core.c.text.lines import Line, Lines
from sigcat.adapter.origins import marked_lines
from sigcat.adapter.templates import rendered

_INDENT = "    "


def c_lines(template: str, /, **names: Any) -> Lines:
    """Lines of a file of C."""
    lines = _indented(Line(*each) for each in marked_lines(rendered(template, **names)))
    return tuple(_spaced(tuple(lines)))


def _indented(part: Iterable[Line]) -> Iterator[Line]:
    depth = 0
    for line in part:
        text = line.text.lstrip()
        if text.startswith("}"):
            depth = max(0, depth - 1)
        indent = max(_INDENT * depth, line.text[: -len(text)], key=len) if text else ""
        yield line._replace(text=indent + text)
        if text.endswith("{") and not text.startswith('extern "C"'):
            depth += 1


_DECLARATION = re.compile(r" +(?:\};|(?!return )(?:const )?\w+ \*?\w+(?:\[\w+\])?(?: = .*)?;)$")
"""A variable, or the end of a table."""


def _spaced(part: Lines) -> Iterator[Line]:
    """Lines, with an empty one where the template has any. Within functions there is one after declarations only.

    Macros that write nothing leave empty lines behind.
    """
    is_function = declares = has_empty = False
    before = "{"
    for line in part:
        if not line.text:
            has_empty = True
            continue
        is_declaration = bool(_DECLARATION.match(line.text))
        if is_function:
            ends = _DECLARATION.match(before) and not is_declaration
            is_spaced = ends and (declares or has_empty) and line.text != "}"
        else:
            is_spaced = has_empty and not before.endswith("{")
        if is_spaced:
            yield Line("")
        yield line
        is_function = line.text == "{" or (is_function and line.text != "}")
        declares = line.text == "{" or (declares and is_declaration)
        before, has_empty = line.text, False
