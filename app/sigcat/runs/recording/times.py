"""Times in nanoseconds, and in seconds with nine decimals as in files."""

import re
from decimal import Decimal, InvalidOperation

NANOSECONDS = 10**9
LATEST = 2**63 - 1

_USUAL = re.compile(r"([0-9]{1,9})(?:\.([0-9]{1,9}))?")


def nanoseconds(text: str) -> int | None:
    """A time in seconds as nanoseconds, the nearest one; None if it is none, or before 0 or after the year 2262."""
    match = _USUAL.fullmatch(text)
    if match:
        return int(match[1]) * NANOSECONDS + int((match[2] or "").ljust(9, "0"))
    return _unusual(text.strip())


def _unusual(text: str) -> int | None:
    try:
        seconds = Decimal(text) if text.isascii() and "_" not in text else Decimal("NaN")
        return round(seconds * NANOSECONDS) if 0 <= seconds <= LATEST // NANOSECONDS else None
    except InvalidOperation:
        return None


LIMITS = f"from 0 to {LATEST // NANOSECONDS:,}"
"""The times that a trace may have, in seconds."""


def seconds(time: int) -> str:
    """A time in seconds, with nine decimals."""
    return f"{time // NANOSECONDS}.{time % NANOSECONDS:09d}"
