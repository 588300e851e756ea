"""Ends of lines of C++ in ROS: levels of two spaces, at most 100 columns."""

import textwrap
from collections.abc import Sequence

from sigcat.function.document.text_filters import AnyText, c_strings

WIDEST = 100
_STEP = "  "


def call(head: str, arguments: Sequence[str], end: str = ");", levels: int = 1) -> str:
    """A call on one line, or with its arguments on the next lines."""
    line = f"{head}({', '.join(arguments)}{end}"
    if len(line) + levels * len(_STEP) <= WIDEST and "\n" not in line:
        return line
    return f"{head}(\n{textwrap.indent(_filled(arguments, levels + 1), _STEP)}{end}"


def _filled(arguments: Sequence[str], levels: int) -> str:
    """Arguments on as few lines as hold them."""
    rows: list[str] = []
    for number, argument in enumerate(arguments):
        piece = argument if number == len(arguments) - 1 else f"{argument},"
        fits = rows and "\n" not in rows[-1] + piece and len(rows[-1]) + len(piece) + 1 + levels * 2 <= WIDEST - 3
        rows = [*rows[:-1], f"{rows[-1]} {piece}"] if fits else [*rows, piece]
    return "\n".join(rows)


def any_of(conditions: Sequence[str]) -> str:
    """The head of a block with a condition of several, on as many lines as it needs, one level in."""
    line = f"if ({' || '.join(conditions)}) {{"
    if len(line) + len(_STEP) <= WIDEST:
        return line
    return f"if (\n{_STEP}" + f" ||\n{_STEP}".join(conditions) + ")\n{"


def literal(words: AnyText, levels: int = 3) -> str:
    """A text as a literal, on as many lines as it needs, where it stands so many levels in."""
    return "\n".join(c_strings(words, WIDEST - levels * len(_STEP) - 4))


_BREAKS = ("(", ", ", " = ")


def fitted(whole: str) -> str:
    """A text whose long lines are broken where they can be: behind a parenthesis, a comma or an assignment."""
    return "\n".join(row for line in whole.split("\n") for row in _fitted(line))


def _fitted(line: str) -> list[str]:
    code = line.lstrip()
    indent = len(line) - len(code)
    if len(line) <= WIDEST or code.startswith(("//", "#", '"')):
        return [line]
    for sign in _BREAKS:
        at = _break(line, sign, indent)
        if at > indent + 8:
            rest = " " * (indent + len(_STEP)) + line[at:].lstrip()
            return [line[:at].rstrip(), *_fitted(rest)]
    return [line]


def _break(line: str, sign: str, indent: int) -> int:
    """Position of a break behind a character that is not in a text."""
    at = line.rfind(sign, indent, WIDEST - 1)
    while at > 0 and line[:at].count('"') % 2:
        at = line.rfind(sign, indent, at)
    return at + len(sign.rstrip()) if at > 0 and line[at + 1 : at + 2] != ")" else -1
