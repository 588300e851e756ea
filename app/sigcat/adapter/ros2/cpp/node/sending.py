"""Messages that a node sends, with what the core says, outside of its lock."""

from typing import Any

from sigcat.adapter.ros2.plan import SentField
from sigcat.function.document.text_filters import c_string


def literal(value: Any) -> str:
    """A value of a document, as C++ writes it."""
    if isinstance(value, bool):
        return "true" if value else "false"
    return repr(value) if isinstance(value, int | float) else c_string(value)


def active(given: SentField) -> int:
    """The number of the core for an active state, where the message has 0 and 1."""
    (_, inactive), (number, is_active) = given.numbers
    assert (inactive, is_active) == (0, 1)
    return number
