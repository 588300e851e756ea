"""Lines of a text as editors, YAML 1.2 and LSP count them: they end with LF, CR LF or CR alone.

`str.splitlines` and libyaml also count others, such as U+2028, as ends.
"""

import re

_LINES = re.compile("[^\r\n]*(?:\r\n|\n|\r)|[^\r\n]+")
_ENDS = re.compile("\r\n|\n|\r")


def lines_of(text: str, *, keepends: bool = False) -> list[str]:
    """The lines of a text, as `str.splitlines` returns them."""
    if keepends:
        return _LINES.findall(text)
    lines = _ENDS.split(text)
    return lines if lines[-1] else lines[:-1]


def line_and_column(text: str, index: int) -> tuple[int, int]:
    """Line and column of a character, from 0."""
    before = _ENDS.split(text[:index])
    return len(before) - 1, len(before[-1])


CONFLICT = ("The file has a merge conflict.", "Resolve it, and remove the lines that git wrote.")
"""Message and fix of a finding about two sides of a merge."""


def line_of_conflict(text: str) -> int:
    """The first line, from 1, that git wrote into a text where two changes meet; 0 without one."""
    conflict = re.search(r"^(?:<{7}|>{7}) ", text, re.MULTILINE)
    return line_and_column(text, conflict.start())[0] + 1 if conflict else 0
