"""Advice for errors in the syntax of TOML, by what is at the place of the error."""

import re
from collections.abc import Sequence

_WORD = re.compile(r"[A-Za-z_][\w.-]*")
_OPEN_LIST = re.compile(r"[^#=]*=\s*\[(?!.*\])")
_KEY = re.compile(r"[\w.-]+\s*=")


def toml_advice(lines: Sequence[str], line: int, column: int) -> str:
    """The fix for an error at a line and column, from 1; empty for one that its message explains."""
    text = lines[line - 1].rstrip("\r\n") if line <= len(lines) else ""
    above = lines[line - 2].rstrip() if 2 <= line <= len(lines) + 1 else ""
    before, rest = text[: column - 1].rstrip() or above, text[column - 1 :]
    signs = {
        "Close the quotation mark.": not rest.strip() and (before.count('"') % 2 or before.count("'") % 2),
        "Write the backslash twice, or use single quotation marks.": "\\" in text[max(column - 3, 0) : column],
        "Write a comma between the values.": rest.startswith(("'", '"')) and before.endswith(("'", '"', "]")),
        "Use straight quotation marks.": rest.startswith(("\u201c", "\u201d", "\u2018", "\u2019")),
        "Write `=` for the colon.": rest.startswith(":"),
        "Remove the comma.": rest.startswith(","),
        _of_word(rest): before.endswith(("=", "[", ",")) and not (_KEY.match(rest) or text.startswith("[[")),
    }
    return next((advice for advice, is_so in signs.items() if is_so), "")


def open_bracket(lines: Sequence[str]) -> tuple[int, int] | None:
    """Line and column of the last list that no later line closes, where a file ends within one."""
    for number in range(len(lines), 0, -1):
        opened = _OPEN_LIST.match(lines[number - 1])
        if opened or "]" in lines[number - 1]:
            return (number, opened.end()) if opened else None
    return None


def _of_word(rest: str) -> str:
    word = _WORD.match(rest)
    if word is None:
        return ""
    is_truth = word[0].lower() in ("true", "false")
    return f"Write `{word[0].lower()}`." if is_truth else "Put quotation marks around the text."
