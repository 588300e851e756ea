"""The comments of a file, and which of them belong to a line: behind it, above it, or above its group."""

import re
from bisect import bisect_left
from collections.abc import Iterator
from functools import cached_property
from typing import NamedTuple

from sigcat.line_numbers import numbered

_TOKEN = re.compile(
    r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|(?P<line>//[^\n]*)|(?P<block>/\*.*?(?:\*/|\Z))',
    re.DOTALL,
)
_FRAME = re.compile(r"^[\s*/!<]+|[\s*/]+$")
_FAR_RIGHT = 20
"""Columns from which a comment on a separate line continues the line before it, as generators write it."""


class Comment(NamedTuple):
    """A comment, without its frame."""

    first: int
    last: int
    column: int
    is_alone: bool
    """Whether its first line has no code before it."""
    text: str


class Comments:
    """The comments of one file by line."""

    def __init__(self, text: str) -> None:
        self._comments = tuple(_joined(_found(text)))
        self._lines = [comment.first for comment in self._comments]
        self._text = text.split("\n")

    def beside(self, line: int, name: str = "") -> str:
        """The comment behind a line, or far right on the line after it; behind a name, where the line declares several."""
        declared = self._declared(line, name)
        for comment in self._comments[bisect_left(self._lines, line) :]:
            if comment.first == line and not comment.is_alone:
                if comment.column < declared:
                    continue
                is_of_another = self._text[line - 1].count(";", declared, comment.column) > 1
                return "" if declared and is_of_another else comment.text
            if comment.first == line + 1 and comment.is_alone and comment.column > _FAR_RIGHT:
                return comment.text
            if comment.first > line:
                break
        return ""

    def above(self, line: int) -> str:
        """The comment that ends on the line before, unless it stands above a group of lines."""
        comment = self._ending(line - 1)
        after = self._text[line].strip() if line < len(self._text) else ""
        is_of_group = after and not after.startswith(("/*", "//", "{", "}", "#"))
        return comment.text if comment and comment.column <= _FAR_RIGHT and not is_of_group else ""

    def heading(self, line: int) -> str:
        """The comment above a group of lines without an empty one between."""
        return self._headings[line - 1] if 0 < line <= len(self._headings) else ""

    @cached_property
    def _headings(self) -> tuple[str, ...]:
        """The heading of every line."""
        alone = [each for each in self._comments if each.is_alone]
        within = {line for each in alone for line in range(each.first, each.last + 1)}
        ending = {each.last: each.text for each in alone if each.column <= _FAR_RIGHT}
        headings, heading = [], ""
        for line, text in enumerate(self._text, 1):
            headings.append(heading)
            if line in ending:
                heading = ending[line]
            elif line not in within and not text.strip():
                heading = ""
        return tuple(headings)

    def all(self) -> Iterator[Comment]:
        """Every comment, in order."""
        return iter(self._comments)

    def _declared(self, line: int, name: str) -> int:
        """The column of a name on a line; 0 if it is not there."""
        text = self._text[line - 1] if name and 0 < line <= len(self._text) else ""
        found = re.search(rf"\b{re.escape(name)}\b\s*(?:\[[^;]*)?[;,=:]", text) if text else None
        return found.start() if found else 0

    def _ending(self, line: int) -> Comment | None:
        at = bisect_left(self._lines, line + 1) - 1
        comment = self._comments[at] if at >= 0 else None
        return comment if comment and comment.last == line and comment.is_alone else None


def _found(text: str) -> Iterator[Comment]:
    for line, match in numbered(text, _TOKEN.finditer(text)):
        start_of_line = text.rfind("\n", 0, match.start()) + 1
        if match.lastgroup is None:
            continue
        is_alone = not text[start_of_line : match.start()].strip()
        last = line + match[0].count("\n")
        yield Comment(line, last, match.start() - start_of_line, is_alone, _unframed(match[0]))


def _joined(comments: Iterator[Comment]) -> Iterator[Comment]:
    """Comments of one line each, below each other in one column, are one comment."""
    before: Comment | None = None
    for comment in comments:
        goes_on = before and comment.is_alone and comment.first == before.last + 1 and comment.column == before.column
        if before and goes_on:
            before = before._replace(last=comment.last, text=f"{before.text}\n{comment.text}".strip())
            continue
        if before:
            yield before
        before = comment
    if before:
        yield before


def _unframed(comment: str) -> str:
    lines = (_FRAME.sub("", line) for line in comment.split("\n"))
    return "\n".join(line for line in lines).strip()
