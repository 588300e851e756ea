"""Places of errors in the syntax of YAML, and advice for them, by the words of libyaml, which has no codes for its errors.

If the words change, advice is missing and nothing else. tests/catalogue/test_yaml_syntax.py has a case of each.
"""

import re
import sys
from collections.abc import Callable, Iterator, Sequence
from typing import Literal, NamedTuple

import yaml

from sigcat.text_lines import CONFLICT, line_and_column, line_of_conflict, lines_of

_KEY = re.compile(r"""(?P<items>(?:- +)*)(?:"[^"]*"|'[^']*'|[^\s"'#][^#]*?):(?:\s|$)""")
_LONGEST_KEY = 1024
"""Characters of a simple key (YAML 1.1, section 7.4.2)."""
_ITEM = re.compile(r"(?:- +)*-(?:\s|$)")
_WIDE_SPACE = re.compile("[ \t]*\u00a0")
_SECOND_KEY = re.compile(r"[ ]*[\w.-]+:[ ]+[^\s\"']+[ ]+([\w.-]+)$")
"""A line with a value, and the key of another one behind it."""
_NO_SPACE = re.compile(r"[ ]*[\w.-]+:(?=[^\s:/])")
"""A key with its colon, and no space behind it."""


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


class SyntaxFault(NamedTuple):
    """The place of an error in a text, line and column from 1, and the fix; an empty fix where the message says enough."""

    message: str
    line: int
    column: int
    fix: str = ""


def syntax_fault(text: str, error: yaml.MarkedYAMLError) -> SyntaxFault:
    """The place where an error can be corrected: libyaml often finds it lines later."""
    message = f"Not valid YAML: {', '.join(part for part in (error.context, error.problem) if part)}."
    if conflict := line_of_conflict(text):
        return SyntaxFault(CONFLICT[0], conflict, 1, CONFLICT[1])
    mark = error.problem_mark or error.context_mark
    if mark is None:
        return SyntaxFault(message, 0, 0)
    context = error.context_mark or mark
    line, column = line_and_column(text, mark.index)
    opened, opened_column = line_and_column(text, context.index)
    found = _Error(lines_of(text), line, column, opened + 1)
    for number in (found.opened, line, line + 1):
        if 0 < number <= len(found.lines) and (wide := _WIDE_SPACE.match(found.lines[number - 1])):
            return SyntaxFault(message, number, wide.end(), "Indent with spaces: this one is a no-break space.")
    return _placed(found, message, opened_column)


def _placed(error: _Error, message: str, opened_column: int) -> SyntaxFault:
    """The fault where its cause is: at the error, or where the part of the text opens that it ends."""
    line, column, opened = error.line + 1, error.column + 1, error.opened
    fix = next((advice(error) for words, advice in _ADVICE.items() if words in message), "")
    if "did not find expected ',' or" in message and opened == line and (beside := _of_list_on_a_line(error)):
        return SyntaxFault(message, line, column, beside)
    if any(words in message for words in _FROM_WHERE_IT_OPENS):
        return SyntaxFault(message, opened, opened_column + 1, fix)
    if any(words in message for words in _AFTER_A_GLUED_KEY) and (glued := _glued_key(error)):
        return SyntaxFault(message, *glued, "Write a space behind the colon.")
    return SyntaxFault(message, line, column, fix)


def _of_list_on_a_line(error: _Error) -> str:
    """The fix of a list that is opened in the line of its error; empty if only its end is missing."""
    before, rest = error.text[: error.column].rstrip(), error.text[error.column :]
    if rest.startswith(("'", '"')) and before.endswith(("'", '"')):
        return "Write a comma between the values."
    return "Close the quotation mark of the value before." if before.endswith(("'", '"')) else ""


def _glued_key(error: _Error) -> tuple[int, int] | None:
    """The line above an error that has no space behind its colon, and so is a text, with the column behind the colon."""
    above = next((line for line in range(error.line, 0, -1) if error.lines[line - 1].strip()), 0)
    glued = _NO_SPACE.match(error.lines[above - 1]) if above else None
    return (above, glued.end() + 1) if glued else None


def _of_indentation(error: _Error) -> str:
    """Advice for a line that is at no level of those above it; for what follows a complete value, to remove it."""
    if error.text[: error.column].strip():
        return "Remove it. If it belongs to a text, quote the whole text."
    open_levels = list(_open_levels(error))
    if _kinds_of(error.text)[0].kind == "item" and all(level.kind == "key" for level in open_levels):
        return "Remove the hyphen: no list begins here."
    if first := next((level for level in open_levels if level.kind == "item" and level.column == 0), None):
        return f"Remove the hyphen in line {first.line}, or write one here."
    levels = [level for level in open_levels if level.kind == _kinds_of(error.text)[0].kind]
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
    if second := _SECOND_KEY.match(error.text[: error.column]):
        return f"Begin a line with `{second[1]}:`. If the colon belongs to a text, quote the text."
    above = error.lines[error.line - 1] if error.line else ""
    if above.strip() and not above.startswith((" ", "#")) and ":" not in above:
        return f"Write a colon behind the name in line {error.line}."
    return "Indent the line as those around it. If the colon belongs to a text, quote the text or write it as a block (`>-`)."


def _of_missing_colon(error: _Error) -> str:
    if len(error.lines[error.opened - 1].partition(": ")[0]) > _LONGEST_KEY:
        return _too_long(error.opened)
    text = error.lines[error.opened - 1].partition(" #")[0].strip()
    if text.startswith("//"):
        return "Begin a comment with `#`."
    more = " If the line continues the text above, indent it." if len(text.split()) > _WORDS_OF_ATTRIBUTE else ""
    return f"Write a colon and a space behind the name.{more}"


_WORDS_OF_ATTRIBUTE = 2


def _too_long(line: int) -> str:
    return f"Shorten the name in line {line}: it has at most {_LONGEST_KEY:,} characters."


def _of_stray_character(error: _Error) -> str:
    return "Indent with spaces, not with tabs." if "\t" in error.text else "Quote the text."


def _always(advice: str) -> Callable[[_Error], str]:
    return lambda _: advice


_FROM_WHERE_IT_OPENS = ("while scanning a quoted scalar", "did not find expected ',' or", "could not find expected ':'")
"""Errors whose cause is where the part of the text begins, not where it ends."""
_AFTER_A_GLUED_KEY = ("did not find expected key", "mapping values are not allowed")
"""Errors in a line whose cause may be the line above it: `type:sensor` is a text."""
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
    "while scanning a quoted scalar": _always("Close the quotation mark that opens here."),
    "did not find expected ',' or": _always("Close the bracket that opens here."),
    "found unknown escape character": _always("Write the backslash twice, or use single quotation marks."),
}
