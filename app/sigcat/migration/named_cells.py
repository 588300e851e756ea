"""Cells of a recording with names of values: a name, or a list of names in JSON."""

import json
import re
from collections.abc import Mapping

_TEXT = re.compile(r'"(?:[^"\\]|\\.)*"')
_SPECIAL = re.compile(r'[,"\r\n]|^\s|\s$')


def names_in(cell: str) -> frozenset[str]:
    """Return the names in a cell."""
    content = _content(cell)
    return frozenset((content, *map(_read, _TEXT.findall(content))))


def renamed(cell: str, names: Mapping[str, str]) -> str:
    """Return a cell with the new names; one without any of them keeps its bytes."""
    content = _content(cell)
    new = names.get(content)
    if new is None:
        new = _TEXT.sub(lambda match: _written(match[0], names), content)
    return cell if new == content else _quoted(new, is_quoted=_is_quoted(cell))


def _is_quoted(cell: str) -> bool:
    text = cell.strip()
    return len(text) > 1 and text[0] == text[-1] == '"'


def _content(cell: str) -> str:
    return cell.strip()[1:-1].replace('""', '"') if _is_quoted(cell) else cell.strip()


def _quoted(content: str, *, is_quoted: bool) -> str:
    escaped = content.replace('"', '""')
    return f'"{escaped}"' if is_quoted or _SPECIAL.search(content) else content


def _read(text: str) -> str:
    try:
        return str(json.loads(text))
    except ValueError:
        return ""


def _written(text: str, names: Mapping[str, str]) -> str:
    new = names.get(_read(text))
    return text if new is None else json.dumps(new, ensure_ascii=not new.isprintable())
