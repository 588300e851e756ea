"""What a compiler or linker says, taken apart: gcc, clang and zig have the same form for that."""

import re
from collections.abc import Iterator
from typing import NamedTuple


class Diagnostic(NamedTuple):
    """An error, and where it is."""

    file: str
    line: int
    column: int
    """0 if the compiler does not say."""
    message: str


_ERROR = re.compile(r"(?P<file>.+?):(?P<line>\d+):(?:(?P<column>\d+):)? (?:fatal )?error: (?P<message>.*)")
_LINKER = re.compile(
    r"(?:\S*ld(?:\.\w+)?: )?(?P<file>[^()\s][^()]*?):(?P<line>\d+):? "
    r"(?P<message>undefined reference to .*|multiple definition of [^;]*)"
)
_SYMBOL = re.compile(r"undefined symbol: (?P<symbol>.+)")
_REFERENCED = re.compile(r">>> referenced by (?P<file>.+?):(?P<line>\d+)")


def diagnostics(text: str) -> Iterator[Diagnostic]:
    """The errors in what was printed; warnings and notes are left out."""
    symbol = ""
    for line in text.splitlines():
        if match := _ERROR.match(line):
            yield Diagnostic(match["file"], int(match["line"]), int(match["column"] or 0), match["message"])
        elif match := _LINKER.match(line):
            yield Diagnostic(match["file"], int(match["line"]), 0, match["message"].replace("`", "'"))
        elif match := _SYMBOL.search(line):
            symbol = match["symbol"]
        elif symbol and (match := _REFERENCED.match(line)):
            yield Diagnostic(match["file"], int(match["line"]), 0, f"undefined reference to '{symbol}'")
            symbol = ""
