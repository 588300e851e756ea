"""Origins of generated lines. A template writes one at the end of its line, so that a compiler's message leads back to it."""

import json
from typing import NamedTuple

from sigcat.function.document.document import Pointer

_MARK = "\x03"


class MarkedLine(NamedTuple):
    """A line of a rendered text, and the pointer into Function JSON that stood at its end."""

    text: str
    source: Pointer | None


def origin(pointer: Pointer) -> str:
    """The end of a line that was made from this part of Function JSON."""
    return f"{_MARK}{json.dumps(pointer)}"


def marked_lines(text: str) -> list[MarkedLine]:
    """Lines of a rendered text, without their marks."""
    rows = (row.partition(_MARK) for row in text.split("\n"))
    return [MarkedLine(row.rstrip(), tuple(json.loads(pointer)) if pointer else None) for row, _, pointer in rows]
