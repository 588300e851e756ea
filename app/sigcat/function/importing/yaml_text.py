"""YAML as text: scalars that are read as they were meant, and comments of one line."""

import json
import re
from collections.abc import Iterable, Mapping
from typing import Any

_PLAIN = re.compile(r"\d+\.\d+\.\d+|[A-Za-z_/.][A-Za-z0-9_./()\[\]^%+-]*(?: [A-Za-z0-9_./()^%+-]+)*[.]?")
_IN_FLOW = re.compile(r"[\[\]{},]")
_WORDS = frozenset(("y", "n", "yes", "no", "on", "off", "true", "false", "null", "none", "nan", "inf", ".nan", ".inf"))
_WIDTH = 118


def scalar(value: Any, *, in_flow: bool = False) -> str:
    """A value in YAML; a text without quotes only where nothing else can be meant."""
    if isinstance(value, str):
        is_plain = _PLAIN.fullmatch(value) and value.lower() not in _WORDS and not (in_flow and _IN_FLOW.search(value))
        return value if is_plain else json.dumps(value, ensure_ascii=not value.isprintable())
    if isinstance(value, float):
        return _float(value)
    return json.dumps(value)


def _float(value: float) -> str:
    """YAML 1.1 reads a number without a point, such as 1e-05, as a text."""
    text = repr(value)
    return text.replace("e", ".0e") if "e" in text and "." not in text else text


def inline(value: Any) -> str:
    """A value within a line."""
    if isinstance(value, Mapping):
        return f"{{{', '.join(f'{scalar(key, in_flow=True)}: {inline(each)}' for key, each in value.items())}}}"
    if isinstance(value, list | tuple):
        return f"[{', '.join(map(inline, value))}]"
    return scalar(value, in_flow=True)


def entry(indent: int, key: str, value: Any) -> str:
    """A line, or several where a list is long."""
    start = f"{' ' * indent}{scalar(key)}:"
    if not isinstance(value, Mapping | list | tuple):
        return f"{start} {scalar(value)}"
    line = f"{start} {inline(value)}"
    return line if len(line) <= _WIDTH or isinstance(value, Mapping) else _wrapped(start, value, indent)


def _wrapped(start: str, values: Iterable[Any], indent: int) -> str:
    lines = [f"{start} ["]
    line = " " * (indent + 2)
    for value in values:
        text = f"{scalar(value, in_flow=True)},"
        if len(line) + len(text) > _WIDTH:
            lines.append(line.rstrip())
            line = " " * (indent + 2)
        line += f"{text} "
    return "\n".join([*lines, line.rstrip(), f"{' ' * indent}]"])


def comment(indent: int, text: str) -> str:
    """A comment in one line, cut where it is long."""
    said = " ".join("".join(each if each.isprintable() else " " for each in text).split())
    line = f"{' ' * indent}# {said}".rstrip()
    return line if len(line) <= 2 * _WIDTH else f"{line[: 2 * _WIDTH - 3]}..."
