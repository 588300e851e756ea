"""Lines of code, each of which may know what it was made from."""

import re
import textwrap
from typing import NamedTuple

from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.long_lines import C, broken
from sigcat.function.document.document import Pointer


class Line(NamedTuple):
    """A line of code."""

    text: str
    source: Pointer | None = None
    """Pointer into Function JSON, so that a compiler's message leads back to its source."""


Lines = tuple[Line, ...]


def lines(text: str, source: Pointer | None = None) -> Lines:
    """The lines of a text, without its common indentation."""
    return tuple(Line(line.rstrip(), source) for line in textwrap.dedent(text).strip("\n").split("\n"))


_OTHER = r'/\*.*?\*/|//[^\n]*|"(?:[^"\\]|\\.)*"'
"""Comments and strings, which decide nothing."""


def code_of(part: Lines) -> str:
    """The code of lines, without comments and strings."""
    return re.sub(_OTHER, " ", "\n".join(line.text for line in part), flags=re.DOTALL)


def replaced(pattern: str, by: str, part: Lines) -> Lines:
    """Lines with a replacement in their code; comments and strings keep their words."""
    wanted = re.compile(f"(?P<other>{_OTHER})|{pattern}", re.DOTALL)
    text = wanted.sub(lambda found: found["other"] or found.expand(by), "\n".join(line.text for line in part))
    return tuple(line._replace(text=row) for line, row in zip(part, text.split("\n"), strict=True)) if part else ()


def c_file(name: str, part: Lines) -> GeneratedFile:
    """A file, with long lines broken."""
    return file_of(name, wrapped(part))


def file_of(name: str, part: Lines) -> GeneratedFile:
    """A file with these lines."""
    return GeneratedFile(name, ("\n".join(line.text for line in part) + "\n").encode())


def wrapped(part: Lines) -> Lines:
    """Lines that are not wider than a page: a comment goes before its line, a long line is broken where it can be.

    A macro of several lines stays as it is.
    """
    before = (Line(""), *part)
    return tuple(
        each
        for previous, line in zip(before, part, strict=False)
        for each in ((line,) if previous.text.endswith("\\") else _wrapped(line))
    )


def _wrapped(line: Line) -> Lines:
    if line.text.lstrip().startswith("/*"):
        return _wrapped_comment(line)
    code, mark, comment = line.text.partition(" /* ")
    indent = " " * (len(code) - len(code.lstrip()))
    if len(line.text) > C.widest and mark and code.strip():
        return (Line(f"{indent}/* {comment}"), *_wrapped(line._replace(text=code)))
    return tuple(line._replace(text=row) for row in broken(line.text, C))


def _wrapped_comment(line: Line) -> Lines:
    indent = " " * (len(line.text) - len(line.text.lstrip()))
    if len(line.text) <= C.widest:
        return (line,)
    rows = textwrap.wrap(line.text.strip(), C.widest - len(indent), subsequent_indent=" * ")
    return tuple(Line(f"{indent}{row}", line.source) for row in rows)
