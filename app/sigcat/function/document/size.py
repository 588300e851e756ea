"""Limits of a document that are checked before it is read."""

from sigcat import codes
from sigcat.findings import Finding
from sigcat.limits import FUNCTION_COLLECTIONS, Limits


def too_crowded(data: bytes, name: str, limits: Limits, openers: tuple[bytes, ...]) -> Finding | None:
    """A finding if a document may hold more lists and mappings than any function has; larger files have separate limits.

    Each of them can be wrong in several ways, and a report of millions of lines is of no use.
    """
    if len(data) > limits.file_bytes:
        return None
    count, values = sum(map(data.count, openers)), data.count(b",")
    if count > FUNCTION_COLLECTIONS:
        message = f"The document has {count:,} lists and mappings; the limit is {FUNCTION_COLLECTIONS:,}."
    elif values > limits.values:
        message = f"The document has {values:,} values; the limit is {limits.values:,}."
    else:
        return None
    return codes.NOT_A_VALUE.finding(message, name, 1, 1)
