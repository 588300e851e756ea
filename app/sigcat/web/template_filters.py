"""Numbers and matches as readers expect to see them."""

import re
from collections.abc import Iterable, Mapping
from datetime import UTC, datetime
from typing import Any

from markupsafe import Markup, escape

_MINUS = "\u2212"
_EXPONENT = re.compile(r"\^(-?\d+)")
_RAISED = str.maketrans("-0123456789", "\u207b⁰¹²³⁴⁵⁶⁷⁸⁹")
_MONTHS = (
    "January", "February", "March", "April", "May", "June", "July", "August", "September", "October", "November",
    "December",
)  # fmt: skip


def number(value: Any, grouped_from: int = 1_000) -> str:
    """A number with a real minus sign and commas between its thousands."""
    if isinstance(value, bool) or not isinstance(value, int | float):
        return str(value)
    is_whole = isinstance(value, int)
    text = f"{value:,}" if is_whole and abs(value) >= grouped_from else f"{value:.12g}"
    return text.replace("-", _MINUS)


def scalar(value: Any) -> str:
    """A number that a catalogue holds: four digits stay together, as they may be a year or a code."""
    return number(value, 10_000)


def count(value: int, one: str, many: str = "") -> str:
    """A count with its noun: `1 node`, `1,673 nodes`."""
    return f"{number(value)}\u00a0{one if value == 1 else many or one + 's'}"


def unit(key: str) -> str:
    """The key of a unit with its exponents raised: `m/s^2` → `m/s²`."""
    return _EXPONENT.sub(lambda power: power.group(1).translate(_RAISED), key)


def datatype(values: Mapping[str, Any]) -> str:
    """The datatype of a node, an array with its size: `float[4]`; empty if it has none."""
    text, size = str(values.get("datatype") or ""), values.get("arraysize")
    return f"{text[:-1]}{size}]" if size and text.endswith("[]") else text


def date(text: str) -> str:
    """A date as text, `12.09.2025` or `2025-09-12` → `12 September 2025`; any other text unchanged."""
    for form in ("%d.%m.%Y", "%Y-%m-%d"):
        try:
            day = datetime.strptime(text, form).replace(tzinfo=UTC)
        except ValueError:
            continue
        return f"{day.day}\u00a0{_MONTHS[day.month - 1]}\u00a0{day.year}"
    return text


def breakable(text: str, joint: str = ".") -> Markup:
    """`text` escaped, with places behind joints where a line may break.

    They are elements and not characters, so that a text that is selected and copied stays what it is.
    """
    joints = re.compile(f"(<[^>]*>)|{re.escape(joint)}(?=[\\w<])")
    return Markup(joints.sub(lambda found: found.group(1) or f"{joint}<wbr>", str(escape(text))))  # noqa: S704 - escaped right here


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
    """`text` escaped, with the text between backticks as code."""
    parts = text.split("`")
    if len(parts) % 2 == 0:
        return escape(text)
    quoted = [Markup("<code>{}</code>").format(part) if odd % 2 else escape(part) for odd, part in enumerate(parts)]
    return Markup("").join(quoted)


def _begins_word(text: str, position: int) -> bool:
    before, here = text[position - 1 : position], text[position]
    return not before.isalnum() or here.isupper() or (here.isdigit() and not before.isdigit())
