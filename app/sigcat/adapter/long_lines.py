"""Long lines of generated C and C++, broken where a reader expects it."""

from typing import NamedTuple


class Layout(NamedTuple):
    """The layout of a language or project."""

    widest: int
    step: str
    """Further indentation of the lines after a break."""
    signs: tuple[str, ...]
    """Signs at which a line is broken, the best one first."""
    least: int
    """Characters that stay before a break."""


_OPERATORS = (" || ", " && ", " ? ", " : ", " * ")
"""Signs that begin the next line."""
C = Layout(120, "    ", (" || ", " && ", " ? ", " : ", ", ", " = ", " * ", "("), 20)
ROS = Layout(100, "  ", ("(", ", ", " = "), 8)
"""As the style guide of ROS 2 has it."""


def fitted(text: str, layout: Layout) -> str:
    """A text without lines that are too long."""
    return "\n".join(row for line in text.split("\n") for row in broken(line, layout))


def broken(line: str, layout: Layout) -> list[str]:
    """A line, on as many as it takes. Directives, comments and lines of a macro stay as they are."""
    code = line.lstrip()
    indent = line[: len(line) - len(code)]
    if len(line) <= layout.widest or code.startswith(("#", "*", "//")) or code.endswith("\\"):
        return [line]
    for sign in layout.signs:
        at = _last(line, sign, len(indent) + 1, layout)
        if at > len(indent) + layout.least:
            cut = at if sign in _OPERATORS else at + len(sign.rstrip())
            rest = broken(f"{indent}{layout.step}{line[cut:].lstrip()}", layout)
            return [line[:cut].rstrip(), *(f"{indent}{layout.step}{each.lstrip()}" for each in rest)]
    return [line]


def _last(line: str, sign: str, start: int, layout: Layout) -> int:
    """Index of the last sign within the width, outside of strings (which have no quotation mark inside) and of `()`."""
    end = layout.widest + len(sign) if sign in _OPERATORS else layout.widest - len(sign.rstrip())
    at = line.rfind(sign, start, end)
    while at >= 0 and (line.count('"', 0, at) % 2 or line.startswith("()", at)):
        at = line.rfind(sign, start, at)
    return at
