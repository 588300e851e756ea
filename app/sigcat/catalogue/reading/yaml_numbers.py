"""Numbers as YAML 1.1 has them: `1.0e+300` is one, `1e300` is a text."""

import re
from math import isfinite

_WRITTEN = re.compile(r"[-+]?(?:\d+\.?\d*|\.\d+)(?P<exponent>[eE][-+]?\d+)?", re.ASCII)
_WITH_EXPONENT = re.compile(r"[-+]?\d*\.\d*[eE][-+]\d+", re.ASCII)

_SMALLEST = "5.0e-324"
"""The least positive number that a double has."""


def yaml_number(value: float) -> str:
    """A number as YAML 1.1 reads it: with a point where it has an exponent."""
    text = repr(value)
    mantissa, _, exponent = text.partition("e")
    return text if not exponent or "." in mantissa else f"{mantissa}.0e{exponent}"


def number_advice(text: str) -> str:
    """The fix for a text in place of a number; empty for one that is not like a number."""
    written = _WRITTEN.fullmatch(text)
    value = float(text) if written else None
    if written is None or value is None or not isfinite(value):
        return ""
    if value == 0 and re.search(r"[1-9]", text.lower().partition("e")[0]):
        return f"Write a number of at least {_SMALLEST}: a double has none between it and 0."
    number = yaml_number(int(text) if text.lstrip("+-").isdecimal() else value)
    if written["exponent"] and not _WITH_EXPONENT.fullmatch(text):
        return f"Write {number}: YAML reads {text[:40]} as a text, as it has no point or no sign in its exponent."
    return f"Write {number}, without quotes."
