"""Received and sent values, one by one, in order of time."""

from typing import NamedTuple

from sigcat.adapter.host.shapes import Value


class Sample(NamedTuple):
    """A value, and when it was received or sent."""

    time: int
    name: str
    value: Value
