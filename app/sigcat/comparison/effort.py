"""Lines of hand-written and of generated files: those with code, and all of them.

A line has code if something is left of it without comments and blanks. Descriptions in a declaration count: a person wrote them.
"""

import re
from collections.abc import Iterable
from pathlib import PurePath
from typing import NamedTuple

_BLOCK = {"c": (r"/\*", r"\*/"), "xml": ("<!--", "-->")}
_LINE = {"c": "//", "hash": "#"}
_KINDS = {
    **dict.fromkeys((".c", ".h", ".cpp", ".hpp", ".idl"), "c"),
    **dict.fromkeys((".xml", ".arxml"), "xml"),
    **dict.fromkeys((".py", ".yaml", ".yml", ".cmake", ".txt", ".msg", ".srv", ".cfg", ".vspec", ".toml"), "hash"),
}


class Counted(NamedTuple):
    """Lines of files."""

    files: int
    code: int
    total: int


def count_lines(files: Iterable[tuple[str, str]]) -> Counted:
    """Count lines of files, given as (name, text); the ending of the name decides what a comment is."""
    counts = [
        (_code_lines(text, _KINDS.get(PurePath(name).suffix, "")), len(text.splitlines())) for name, text in files
    ]
    return Counted(len(counts), sum(code for code, _ in counts), sum(total for _, total in counts))


def _code_lines(text: str, kind: str) -> int:
    if kind in _BLOCK:
        begin, end = _BLOCK[kind]
        text = re.sub(f"{begin}.*?{end}", lambda found: "\n" * found[0].count("\n"), text, flags=re.DOTALL)
    mark = _LINE.get(kind)
    return sum(1 for line in text.splitlines() if (bare := line.strip()) and not (mark and bare.startswith(mark)))
