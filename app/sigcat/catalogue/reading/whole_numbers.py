"""Whole numbers of documents, as large as a double: arithmetic mixes both, and raises an error beyond."""

import sys


def held_as_double(number: int) -> int:
    """Return a number that a double can hold, if not exactly. Raises ValueError for a larger one."""
    if abs(number) > sys.float_info.max:
        raise ValueError(f"a number must be at most {sys.float_info.max:.1e}")
    return number


def whole_number(text: str) -> int:
    """Return the number of a text in JSON. Raises ValueError if it is too long, or a double cannot hold it."""
    return held_as_double(int(text))
