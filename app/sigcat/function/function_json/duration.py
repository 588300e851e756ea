"""Durations, which the wire format writes as texts."""

import re

_DURATION = re.compile(r"\s*(\d+(?:\.\d*)?|\.\d+)\s*(us|µs|ms|s|)\s*", re.IGNORECASE)
_MILLISECONDS = {"": 1.0, "ms": 1.0, "s": 1000.0, "us": 0.001, "µs": 0.001}


def milliseconds(text: str | None) -> float | None:
    """The duration that a text of the wire format means, in ms: `100`, `100 ms`, `0.1 s`; None if it means none."""
    match = _DURATION.fullmatch(text) if text else None
    return float(match[1]) * _MILLISECONDS[match[2].lower()] if match else None
