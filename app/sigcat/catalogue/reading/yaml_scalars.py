"""Scalars as YAML 1.1 has them: `1.0e+300` is a number and `1e300` a text; `Off` is false."""

import datetime as dt
import re
from math import isfinite
from typing import Any

# Texts: compiled patterns would cost each start time, and few files need them.
_WRITTEN = r"(?a)[-+]?(?:\d+\.?\d*|\.\d+)(?P<exponent>[eE][-+]?\d+)?"
_WITH_EXPONENT = r"(?a)[-+]?\d*\.\d*[eE][-+]\d+"
_WITH_UNIT = r"[-+]?\d{1,20}(?:\.\d{1,20})? ?(?P<unit>(?![eEoxX]\d)[^\W\d_][\w/^%]{0,9}|[%°])"
_WITH_COMMA = r"(?a)[-+]?\d{1,20},\d{1,20}"

_WORDS = "Quote it: YAML reads words such as ON, OFF, YES and NO as true and false."
_SMALLEST = "5.0e-324"
"""The least positive number that a double has."""


def yaml_number(value: float) -> str:
    """A number as YAML 1.1 reads it: with a point where it has an exponent."""
    text = repr(value)
    mantissa, _, exponent = text.partition("e")
    return text if not exponent or "." in mantissa else f"{mantissa}.0e{exponent}"


def number_advice(text: str, *, is_whole: bool = False) -> str:
    """The fix for a text in place of a number; empty for one that is not like a number, or is none of the whole ones."""
    written = re.fullmatch(_WRITTEN, text)
    value = float(text) if written else None
    if written is None or value is None or not isfinite(value):
        return _plain_number(text)
    if value == 0 and re.search(r"[1-9]", text.lower().partition("e")[0]):
        return f"Write a number of at least {_SMALLEST}: a double has none between it and 0."
    if is_whole and value != int(value):
        return ""
    number = yaml_number(int(value) if is_whole or text.lstrip("+-").isdecimal() else value)
    if is_read_as_text(text):
        return f"Write {number}: YAML reads {text[:40]} as a text, as it has no point or no sign in its exponent."
    return f"Write {number}, without quotes."


def _plain_number(text: str) -> str:
    """The fix for a number with a unit or a comma."""
    if with_unit := re.fullmatch(_WITH_UNIT, text):
        return f"Write the number without {with_unit['unit']!r}, in the unit of the field."
    return f"Write {text.replace(',', '.')}, with a point." if re.fullmatch(_WITH_COMMA, text) else ""


def quote_it(value: Any) -> str:
    """Return the fix for a text that YAML reads as something else; nothing for a list or mapping."""
    if isinstance(value, bool):
        return _WORDS
    if isinstance(value, dt.date):
        return "Quote it: YAML reads it as a date."
    return "Quote it: YAML reads it as a number." if isinstance(value, int | float) else ""


def is_read_as_text(written: Any) -> bool:
    """Whether YAML reads a number as a text because of the form of its exponent: `1e-12`."""
    match = re.fullmatch(_WRITTEN, written) if isinstance(written, str) else None
    return match is not None and match["exponent"] is not None and not re.fullmatch(_WITH_EXPONENT, written)
