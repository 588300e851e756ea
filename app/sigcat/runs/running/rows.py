"""Results of the driver: events, and blocks of whole rows, which are decoded only where their values are needed."""

import struct
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import NamedTuple, Protocol

from sigcat.adapter.host.shapes import Packing, Value

_HEAD = struct.Struct("=cIQ")
_SEQUENCE = struct.Struct("=Q")
NO_CALL = 2**32 - 1


class Row(NamedTuple):
    """Values that were sent at a time, with the call that ended then, if any."""

    time: int
    call: int | None
    values: tuple[tuple[int, Value], ...]
    """Sent values, by the numbers of exits."""


class Received(NamedTuple):
    """A value of the trace that was received."""

    time: int
    entry: int
    value: Value


class Block(NamedTuple):
    """Bytes of whole rows and of received values."""

    data: bytes


class InitFails(NamedTuple):
    """The initialization of a function has failed."""

    member: int


class Stored(NamedTuple):
    """A part of the values that a function keeps."""

    kept: int
    value: Value


class NoEnd(NamedTuple):
    """Calls trigger each other without end."""

    time: int


class Finished(NamedTuple):
    """The run is over."""


Event = Block | InitFails | Stored | NoEnd | Finished


class Garbled(Exception):
    """Results are damaged: a row is missing, or a record is none. The message says it as text."""


class Layout(NamedTuple):
    """Values of records, by their numbers."""

    exits: Sequence[Packing]
    entries: Sequence[Packing]
    kept: Sequence[Packing]


class Progress:
    """Rows and calls until now."""

    def __init__(self) -> None:
        self.rows = 0
        self.begun: tuple[int, int] | None = None
        """The call that has begun and not returned, and its time."""
        self.time: int | None = None
        """When the last call began."""
        self.last: dict[int, bytes] = {}
        self.sent: Callable[[], Mapping[int, bytes]] = lambda: self.last
        """Values that were sent last, by the numbers of exits."""


class Scan(Protocol):
    """A function that checks records and notes progress. It stops before the first one that is cut, wrong or an event.

    Returns where the last whole row ends, and where it stopped.
    """

    def __call__(self, data: bytes, at: int, progress: Progress) -> tuple[int, int]:
        """Check records from an index on."""
        ...


def scanner(layout: Layout) -> Scan:
    """The function that checks records, in Python."""
    sizes = _sizes(layout)

    def scan(data: bytes, at: int, progress: Progress) -> tuple[int, int]:
        whole = at
        is_within = False
        while at + _HEAD.size <= len(data):
            tag, number, time = _HEAD.unpack_from(data, at)
            size = sizes.get((tag, number)) if tag in b"SR" else _PLAIN.get(tag)
            if size is None or at + size > len(data):
                break
            if tag == b"E":
                if _SEQUENCE.unpack_from(data, at + _HEAD.size)[0] != progress.rows:
                    break
                progress.rows += 1
            elif tag == b"S":
                progress.last[number] = data[at + _HEAD.size : at + size]
            elif tag != b"R":
                progress.begun = (number, time) if tag == b"B" else None
                progress.time = time
            is_within = tag == b"S" or (is_within and tag != b"E")
            at += size
            whole = whole if is_within else at
        return whole, at

    return scan


_PLAIN = {b"B": _HEAD.size, b"D": _HEAD.size, b"E": _HEAD.size + _SEQUENCE.size}


def _sizes(layout: Layout) -> Mapping[tuple[bytes, int], int]:
    """Bytes of records of values, by tag and number."""
    listed = ((b"S", layout.exits), (b"R", layout.entries), (b"K", layout.kept))
    return {
        (tag, number): _HEAD.size + each.struct.size for tag, group in listed for number, each in enumerate(group)
    }  # fmt: skip


def events(pieces: Iterable[bytes], layout: Layout, scan: Scan, progress: Progress) -> Iterator[Event]:
    """Everything that the driver reports. A record that is cut off, as when it is stopped, is left out. Raises Garbled."""
    rest = b""
    for piece in pieces:
        data, at = rest + piece, 0
        while True:
            whole, end = scan(data, at, progress)
            if whole > at:
                yield Block(data[at:whole])
            found = _event(data, end, layout, progress, is_whole=whole == end)
            if found is None:
                break
            event, at = found
            yield event
        rest = data[whole:]


def _event(data: bytes, at: int, layout: Layout, progress: Progress, *, is_whole: bool) -> tuple[Event, int] | None:
    """Read a record that belongs to no row, and its end; None if it is cut. Raises Garbled."""
    if at + _HEAD.size > len(data):
        return None
    tag, number, time = _HEAD.unpack_from(data, at)
    end = at + _HEAD.size
    known = {b"S": layout.exits, b"R": layout.entries, b"K": layout.kept}.get(tag)
    if tag not in b"SRKBDEFLZ" or (known is not None and number >= len(known)):
        raise Garbled(f"what follows row {progress.rows} cannot be read")
    if tag == b"E" and len(data) >= end + _SEQUENCE.size:
        (found,) = _SEQUENCE.unpack_from(data, end)
        raise Garbled(f"row {progress.rows + 1} is missing: row {found + 1} follows row {progress.rows}")
    if tag in b"SRBDE":
        return None
    if not is_whole:
        raise Garbled(f"row {progress.rows + 1} has no end")
    if tag == b"K":
        body = layout.kept[number]
        whole = end + body.struct.size
        return (Stored(number, body.unpack(data, end)), whole) if whole <= len(data) else None
    return (InitFails(number) if tag == b"F" else NoEnd(time) if tag == b"L" else Finished()), end


def decoded(block: Block, layout: Layout) -> Iterator[Row | Received]:
    """Rows, and what was received, of a block."""
    data, at = block.data, 0
    sent: list[tuple[int, Value]] = []
    while at < len(data):
        tag, number, time = _HEAD.unpack_from(data, at)
        at += _HEAD.size
        if tag == b"S":
            sent.append((number, layout.exits[number].unpack(data, at)))
            at += layout.exits[number].struct.size
        elif tag == b"R":
            yield Received(time, number, layout.entries[number].unpack(data, at))
            at += layout.entries[number].struct.size
        elif tag == b"E":
            yield Row(time, None if number == NO_CALL else number, tuple(sent))
            sent = []
            at += _SEQUENCE.size
