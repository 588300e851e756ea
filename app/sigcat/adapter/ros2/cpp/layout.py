"""Ends of lines of C++ in ROS: levels of two spaces, at most 100 columns."""

WIDEST = 100
_STEP = "  "


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
