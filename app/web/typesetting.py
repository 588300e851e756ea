"""Numbers and matches as readers expect to see them."""

import re
from collections.abc import Iterable
from typing import Any

from markupsafe import Markup, escape

_NARROW_SPACE = "\u202f"
_MINUS = "\u2212"
_GROUPED_FROM = 10_000


def number(value: Any) -> str:
    """A number with a real minus sign, and thousands set apart from five digits on."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return str(value)
    is_whole = isinstance(value, int)
    text = f"{value:,}".replace(",", _NARROW_SPACE) if is_whole and abs(value) >= _GROUPED_FROM else f"{value:.12g}"
    return text.replace("-", _MINUS)


def count(value: int, one: str, many: str = "") -> str:
    """A count with its noun: `1 node`, `12 340 nodes`."""
    return f"{number(value)}\u00a0{one if value == 1 else many or one + 's'}"


def marked(text: str, sought: Iterable[str]) -> Markup:
    """`text` escaped, with the beginnings of words that match a sought word marked."""
    pattern = "|".join(re.escape(word) for word in sorted(set(sought), key=len, reverse=True) if word)
    if not pattern:
        return escape(text)
    parts: list[Markup] = []
    end = 0
    for match in re.finditer(pattern, text, re.IGNORECASE):
        if match.start() < end or not _begins_word(text, match.start()):
            continue
        parts += [escape(text[end : match.start()]), Markup("<mark>{}</mark>").format(match.group())]
        end = match.end()
    return Markup("").join([*parts, escape(text[end:])])


def with_code(text: str) -> Markup:
    """`text` escaped, with what stands between backticks as code."""
    parts = text.split("`")
    if len(parts) % 2 == 0:
        return escape(text)
    quoted = [Markup("<code>{}</code>").format(part) if odd % 2 else escape(part) for odd, part in enumerate(parts)]
    return Markup("").join(quoted)


def _begins_word(text: str, position: int) -> bool:
    before, here = text[position - 1 : position], text[position]
    return not before.isalnum() or here.isupper() or (here.isdigit() and not before.isdigit())
