"""Advice for errors in the syntax of YAML, by the words of libyaml, which has no codes for its errors.

If the words change, advice is missing and nothing else. tests/catalogue/test_yaml_syntax.py has a case of each.
"""

import re
import sys
from collections.abc import Callable, Iterator, Sequence
from typing import Literal, NamedTuple

import yaml

from sigcat.text_lines import line_and_column, lines_of

_KEY = re.compile(r"""(?P<items>(?:- +)*)(?:"[^"]*"|'[^']*'|[^\s"'#][^#]*?):(?:\s|$)""")
_LONGEST_KEY = 1024
"""Characters of a simple key (YAML 1.1, section 7.4.2)."""
_ITEM = re.compile(r"(?:- +)*-(?:\s|$)")


class _Error(NamedTuple):
    """An error, and the lines of the text."""

    lines: Sequence[str]
    line: int
    """From 0, as the column."""
    column: int
    opened: int
    """Line in which the part of the text begins that cannot be read."""

    @property
    def text(self) -> str:
        """The line of the error."""
        return self.lines[self.line] if self.line < len(self.lines) else ""


def syntax_advice(text: str, error: yaml.MarkedYAMLError, message: str) -> str:
    """The fix for an error; empty for one that says enough."""
    mark = error.problem_mark or error.context_mark
    if mark is None:
        return ""
    context = error.context_mark or mark
    line, column = line_and_column(text, mark.index)
    opened, _ = line_and_column(text, context.index)
    found = _Error(lines_of(text), line, column, opened + 1)
    return next((advice(found) for words, advice in _ADVICE.items() if words in message), "")


def _of_indentation(error: _Error) -> str:
    """Advice for a line that is at no level of those above it; for what follows a complete value, to remove it."""
    if error.text[: error.column].strip():
        return "Remove it. If it belongs to a text, quote the whole text."
    levels = [level for level in _open_levels(error) if level.kind == _kinds_of(error.text)[0].kind]
    deeper = min((level for level in levels if level.column > error.column), default=None)
    flatter = max((level for level in levels if level.column < error.column), default=None)
    places = [f"with {_spaces(level.column)}, as line {level.line}" for level in (deeper, flatter) if level is not None]
    return f"Indent the line {', or '.join(places)}." if places else "Indent the line as those around it."


class _Level(NamedTuple):
    """A level of indentation, and what is at it: an item of a list, a key or text."""

    column: int
    kind: Literal["item", "key", "text"]
    line: int = 0


def _open_levels(error: _Error) -> Iterator[_Level]:
    """Levels of the lines above that no line after them has left, the deepest first."""
    outermost = sys.maxsize
    for line in range(error.line, 0, -1):
        text = error.lines[line - 1]
        levels = [level for level in _kinds_of(text) if level.column < outermost]
        if levels and text.strip() and not text.lstrip().startswith("#"):
            yield from (level._replace(line=line) for level in levels)
            outermost = levels[0].column
        if outermost == 0:
            return


def _kinds_of(text: str) -> list[_Level]:
    """Levels that a line has: `- name: A` has that of an item, and that of a key."""
    rest = text.lstrip(" ")
    start = len(text) - len(rest)
    is_item, key = _ITEM.match(rest), _KEY.match(rest)
    levels = [_Level(start, "item")] if is_item else []
    if key:
        levels.append(_Level(start + len(key["items"]), "key"))
    return levels or [_Level(start, "text")]


def _spaces(count: int) -> str:
    return "no space" if count == 0 else "1 space" if count == 1 else f"{count} spaces"


def _of_stray_colon(error: _Error) -> str:
    if error.column > _LONGEST_KEY:
        return _too_long(error.line + 1)
    return "Indent the line as those around it. If the colon belongs to a text, quote the text or write it as a block (`>-`)."


def _of_missing_colon(error: _Error) -> str:
    if len(error.lines[error.opened - 1].partition(": ")[0]) > _LONGEST_KEY:
        return _too_long(error.opened)
    return f"Write a colon and a space behind the name in line {error.opened}."


def _too_long(line: int) -> str:
    return f"Shorten the name in line {line}: it has at most {_LONGEST_KEY:,} characters."


def _of_stray_character(error: _Error) -> str:
    return "Indent with spaces, not with tabs." if "\t" in error.text else "Quote the text."


def _always(advice: str) -> Callable[[_Error], str]:
    return lambda _: advice


_ASTERISK = _always("If the asterisk belongs to a text, quote the text.")
_ADVICE: dict[str, Callable[[_Error], str]] = {
    "mapping values are not allowed": _of_stray_colon,
    "cannot start any token": _of_stray_character,
    "found a tab character": _always("Indent with spaces, not with tabs."),
    "found undefined alias": _ASTERISK,
    "while scanning an alias": _ASTERISK,
    "did not find expected key": _of_indentation,
    "did not find expected '-' indicator": _of_indentation,
    "did not find expected <document start>": _of_indentation,
    "could not find expected ':'": _of_missing_colon,
    "while scanning a quoted scalar": lambda error: f"Close the quotation mark that opens in line {error.opened}.",
    "did not find expected ',' or": lambda error: f"Close the bracket that opens in line {error.opened}.",
    "found unknown escape character": _always("Write the backslash twice, or use single quotation marks."),
}
