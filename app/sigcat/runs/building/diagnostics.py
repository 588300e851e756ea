"""Parser of the output of compilers and linkers: gcc, clang and zig have the same form."""

import re
from collections.abc import Iterator, Sequence
from typing import NamedTuple


class Diagnostic(NamedTuple):
    """An error, and where it is."""

    file: str
    line: int
    column: int
    """0 if the compiler does not say."""
    message: str


_ERROR = re.compile(r"(?P<file>.+?):(?P<line>\d+):(?:(?P<column>\d+):)? (?:fatal )?error: (?P<message>.*)")
_WARNING = re.compile(r"(?P<file>.+?):(?P<line>\d+):(?P<column>\d+): warning: (?P<message>.*)")
_UNREADABLE = re.compile(r"cc1\w*: (?:fatal )?error: (?P<file>.+?): (?P<message>[^:]+)")
"""gcc for a file that it cannot read."""
_LINKER = re.compile(
    r"(?:\S*ld(?:\.\w+)?: )?(?P<file>[^()\s][^()]*?):(?P<line>\d+):? "
    r"(?P<message>undefined reference to .*|multiple definition of [^;]*)"
)
_SYMBOL = re.compile(r"undefined symbol: (?P<symbol>.+)")
_REFERENCED = re.compile(r">>> referenced by (?P<file>.+?):(?P<line>\d+)")


_ASSERTION = "static assertion failed"
_EXPANSION = re.compile(r"(?P<file>.+?):(?P<line>\d+):(?P<column>\d+): note: in expansion of macro")


def diagnostics(text: str) -> Iterator[Diagnostic]:
    """The errors in what was printed; warnings and notes are left out."""
    lines = text.splitlines()
    symbol = ""
    for number, line in enumerate(lines):
        if match := _ERROR.match(line):
            found = Diagnostic(match["file"], int(match["line"]), int(match["column"] or 0), match["message"])
            yield _where_it_is_used(found, lines[number + 1 :]) if _ASSERTION in found.message else found
        elif match := _UNREADABLE.fullmatch(line):
            yield Diagnostic(match["file"], 0, 0, match["message"])
        elif match := _LINKER.match(line):
            yield Diagnostic(match["file"], int(match["line"]), 0, match["message"].replace("`", "'"))
        elif match := _SYMBOL.search(line):
            symbol = match["symbol"]
        elif symbol and (match := _REFERENCED.match(line)):
            yield Diagnostic(match["file"], int(match["line"]), 0, f"undefined reference to '{symbol}'")
            symbol = ""


def warnings(text: str) -> Iterator[Diagnostic]:
    """The warnings in what was printed."""
    for match in filter(None, map(_WARNING.match, text.splitlines())):
        yield Diagnostic(match["file"], int(match["line"]), int(match["column"]), match["message"])


def _where_it_is_used(found: Diagnostic, rest: Sequence[str]) -> Diagnostic:
    """An assertion that a macro makes: gcc has the place of the macro first, and that of its use in notes."""
    for line in rest:
        if _ERROR.match(line):
            break
        if match := _EXPANSION.match(line):
            found = found._replace(file=match["file"], line=int(match["line"]), column=int(match["column"]))
    return found
