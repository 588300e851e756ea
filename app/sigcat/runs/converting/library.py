"""The library, loaded: its functions take bytes and give bytes."""

import ctypes
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat.adapter.host.ranges import Range
from sigcat.runs.converting.layout import ColumnTables, ShapeTables
from sigcat.runs.recording.outside import Outside

SOURCE = Path(__file__).with_name("sigcat_convert.c")
_U64 = ctypes.c_uint64
_READ_ROOM = _WRITE_ROOM = 1 << 20


class _Reading(ctypes.Structure):
    _fields_ = (
        *((name, ctypes.c_void_p) for name in ("columns", "ranges", "targets", "symbols", "texts")),
        *((name, _U64) for name in (
            "column_count", "row_room", "time", "has_row", "has_time", "lines", "row_line", "first", "written", "is_left",
        )),
    )  # fmt: skip


class _Range(ctypes.Structure):
    _fields_ = (
        *((name, ctypes.c_double) for name in ("least", "greatest")),
        *((name, _U64) for name in ("is_outside", "count", "line", "time")),
    )


class _Writing(ctypes.Structure):
    _fields_ = (
        *((name, ctypes.c_void_p) for name in ("exits", "entries", "calls", "steps", "symbols", "texts")),
        *((name, _U64) for name in ("exit_count", "entry_count", "call_count", "column_count", "written", "is_left")),
    )  # fmt: skip


class _Progress(ctypes.Structure):
    _fields_ = (
        *((name, _U64) for name in ("rows", "has_begun", "begun", "begun_time", "has_time")),
        *((name, ctypes.c_void_p) for name in ("last", "last_place", "has_last")),
        ("whole", _U64),
    )  # fmt: skip


class Read(NamedTuple):
    """A part of a trace that was converted."""

    used: int
    """Bytes of the trace."""
    data: bytes
    """Input of the driver."""
    is_left: bool
    """Whether the next line, or message, is for Python."""


def loaded(path: Path) -> ctypes.CDLL | None:
    """The library; None if this process cannot load it, or numbers are in another order here."""
    try:
        library = ctypes.CDLL(str(path))
    except OSError:
        return None
    for name in ("read_csv", "is_ordered", "read_mcap", "scan", "write_csv", "write_mcap", "index_mcap", "is_little"):
        getattr(library, f"sigcat_{name}").restype = _U64
    return library if sys.byteorder == "little" and library.sigcat_is_little() else None


class Reader:
    """Converts parts of a trace."""

    def __init__(self, library: ctypes.CDLL, tables: ColumnTables, ranges: Sequence[Range]) -> None:
        self._library, self._tables = library, tables
        self._ranges = (_Range * len(ranges))(*(_Range(each.least, each.greatest) for each in ranges))
        self._out = ctypes.create_string_buffer(max(_READ_ROOM, 2 * tables.row_room))
        self.state = _Reading(
            _address(tables.columns), ctypes.addressof(self._ranges), _address(tables.targets), _address(tables.symbols), _address(tables.texts),
            tables.total, tables.row_room,
        )  # fmt: skip

    @property
    def outside(self) -> list[Outside]:
        """Values of each column that were outside of its range."""
        return [Outside(each.count, each.line, each.time) for each in self._ranges]

    def read_csv(self, data: bytes, at: int) -> Read:
        """Convert whole lines."""
        used = self._library.sigcat_read_csv(
            ctypes.byref(self.state), _at(data, at), _U64(len(data) - at), self._out, _U64(len(self._out))
        )
        return self._read(used)

    def read_mcap(self, channels: "ctypes.Array[ctypes.c_int32]", data: bytes, at: int) -> Read:
        """Convert messages; `channels` has the columns of channels."""
        used = self._library.sigcat_read_mcap(
            ctypes.byref(self.state), channels, _at(data, at), _U64(len(data) - at), self._out, _U64(len(self._out))
        )
        return self._read(used)

    def is_ordered(self, data: bytes, since: int) -> int | None:
        """The time of the last message if all are in order of time; else None."""
        time = _U64(since)
        is_ordered = self._library.sigcat_is_ordered(data, _U64(len(data)), ctypes.byref(time))
        return time.value if is_ordered else None

    def _read(self, used: int) -> Read:
        return Read(used, bytes(memoryview(self._out)[: self.state.written]), bool(self.state.is_left))


UNKNOWN, IGNORED = -1, -2
"""Columns of a channel that Python is asked about, and of one that is not read."""


def channel_table() -> "ctypes.Array[ctypes.c_int32]":
    """Columns of channels, none of which is known yet."""
    table = (ctypes.c_int32 * 65536)()
    ctypes.memset(table, 0xFF, ctypes.sizeof(table))
    return table


class Writer:
    """Writes blocks of whole rows."""

    def __init__(self, library: ctypes.CDLL, tables: ShapeTables) -> None:
        self._library, self._tables = library, tables
        self._out = ctypes.create_string_buffer(max(_WRITE_ROOM, 4 * tables.longest))
        self._columns = (ctypes.c_void_p * (tables.counts[3] + 1))()
        self._counts = (ctypes.c_uint32 * 65536)()
        self.state = _Writing(*map(_address, tables[:6]), *tables.counts)

    def csv(self, data: bytes, at: int) -> tuple[int, bytes, bool]:
        """Bytes of a block that were written, the text, and whether what follows is for Python."""
        return self._written(self._library.sigcat_write_csv, data, at, self._columns)

    def mcap(self, data: bytes, at: int) -> tuple[int, bytes, bool]:
        """Bytes of a block that were written, the messages, and whether what follows is for Python."""
        return self._written(self._library.sigcat_write_mcap, data, at)

    def indexes(self, messages: bytes) -> list[tuple[int, bytes]]:
        """Times and places of messages, by channel."""
        out = ctypes.create_string_buffer(len(messages))
        self._library.sigcat_index_mcap(messages, _U64(len(messages)), out, self._counts)
        found, at, data = [], 0, bytes(out)
        for channel, count in enumerate(self._counts[: self._most_channels]):
            if count:
                found.append((channel, data[at : at + 16 * count]))
                at += 16 * count
        return found

    @property
    def _most_channels(self) -> int:
        return sum(self._tables.counts) + 2

    def _written(
        self, write: "ctypes._NamedFuncPointer", data: bytes, at: int, *more: object
    ) -> tuple[int, bytes, bool]:
        used = write(
            ctypes.byref(self.state), _at(data, at), _U64(len(data) - at), self._out, _U64(len(self._out)), *more
        )
        return at + used, bytes(memoryview(self._out)[: self.state.written]), bool(self.state.is_left)


class Scanner:
    """Checks records of results, and notes what was sent last."""

    def __init__(self, library: ctypes.CDLL, tables: ShapeTables, sizes: Sequence[int]) -> None:
        self._library, self._sizes = library, sizes
        self._writer = Writer(library, tables)
        self._places = (_U64 * (len(sizes) + 1))(*(sum(sizes[:index]) for index in range(len(sizes))))
        self._last = ctypes.create_string_buffer(sum(sizes) + 1)
        self._has_last = ctypes.create_string_buffer(len(sizes) + 1)
        self.state = _Progress(last=ctypes.addressof(self._last), last_place=ctypes.addressof(self._places),
                               has_last=ctypes.addressof(self._has_last))  # fmt: skip

    def scan(self, data: bytes, at: int) -> tuple[int, int]:
        """Return the end of the last whole row, and the place where the scan stopped."""
        end = self._library.sigcat_scan(
            ctypes.byref(self._writer.state), data, _U64(at), _U64(len(data)), ctypes.byref(self.state)
        )
        return self.state.whole, end

    @property
    def last(self) -> dict[int, bytes]:
        """Values that were sent last, by the numbers of exits."""
        last, has_last = bytes(self._last), bytes(self._has_last)
        return {
            number: last[self._places[number] : self._places[number] + size]
            for number, size in enumerate(self._sizes)
            if has_last[number]
        }


def _address(data: bytes) -> int | None:
    """Address of bytes, which the caller keeps."""
    return ctypes.cast(ctypes.c_char_p(data), ctypes.c_void_p).value


def _at(data: bytes, at: int) -> ctypes.c_void_p:
    return ctypes.c_void_p((_address(data) or 0) + at)
