"""Rows of a run, made of what the driver tells."""

import struct
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from sigcat.runs.recording.shapes import Packing, Value

_HEAD = struct.Struct("=cIQ")
NO_CALL = 2**32 - 1


class Row(NamedTuple):
    """What was sent at a time; where a call ended then, by this call."""

    time: int
    call: int | None
    values: tuple[tuple[int, Value], ...]
    """What was sent, by the numbers of exits."""


class Begins(NamedTuple):
    """A call of the code begins."""

    time: int
    call: int


class Returns(NamedTuple):
    """The call that began has returned."""


class InitFails(NamedTuple):
    """The initialization of a function has failed."""

    member: int


class Stored(NamedTuple):
    """A part of what a function keeps."""

    kept: int
    value: Value


class NoEnd(NamedTuple):
    """Calls trigger each other without end."""

    time: int


class Finished(NamedTuple):
    """The run is over."""


Event = Row | Begins | Returns | InitFails | Stored | NoEnd | Finished


def events(pieces: Iterable[bytes], exits: Sequence[Packing], kept: Sequence[Packing]) -> Iterator[Event]:
    """What the driver tells. A record that is cut off, as when it is stopped, is left out."""
    rest = b""
    sent: list[tuple[int, Value]] = []
    for piece in pieces:
        data, at = rest + piece, 0
        while at + _HEAD.size <= len(data):
            tag, number, time = _HEAD.unpack_from(data, at)
            body = exits[number] if tag == b"S" else kept[number] if tag == b"K" else None
            size = _HEAD.size + (body.struct.size if body else 0)
            if at + size > len(data):
                break
            if tag == b"S":
                sent.append((number, exits[number].unpack(data, at + _HEAD.size)))
            elif tag == b"E":
                yield Row(time, None if number == NO_CALL else number, tuple(sent))
                sent = []
            elif tag == b"K":
                yield Stored(number, kept[number].unpack(data, at + _HEAD.size))
            else:
                yield _event(tag, number, time)
            at += size
        rest = data[at:]


def _event(tag: bytes, number: int, time: int) -> Event:
    if tag == b"B":
        return Begins(time, number)
    if tag == b"D":
        return Returns()
    if tag == b"F":
        return InitFails(number)
    return NoEnd(time) if tag == b"L" else Finished()
