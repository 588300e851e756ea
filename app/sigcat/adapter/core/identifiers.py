"""Names of interfaces as identifiers of C and C++."""

import re
from collections.abc import Iterable

from sigcat.reserved_words import is_reserved

_NOT_IDENTIFIER = re.compile(r"[^A-Za-z0-9_]+")


def identifier(name: str) -> str:
    """A name that C and C++ take: `Wheel speed` → `Wheel_speed`, `switch` → `switch_`, `UINT8_MAX` → `UINT8_MAX_`."""
    text = _NOT_IDENTIFIER.sub("_", name).strip("_") or "unnamed"
    return f"{text}_" if is_reserved(text) else f"n{text}" if text[0].isdigit() else text


def unique(name: str, taken: Iterable[str]) -> str:
    """The name itself, or with the first number behind it that makes it unique."""
    known = set(taken)
    if name not in known:
        return name
    return next(numbered for number in range(2, len(known) + 3) if (numbered := f"{name}_{number}") not in known)
