"""A trace, converted to the input of the driver: by the library in C where it takes it, else by Python."""

import ctypes
from collections.abc import Iterable, Mapping, Sequence
from typing import BinaryIO

from sigcat.adapter.host.ranges import NO_RANGE
from sigcat.adapter.host.shapes import Shape
from sigcat.findings import Finding
from sigcat.limits import TRACE_ROW_BYTES
from sigcat.runs.converting.layout import SKIPPED, column_tables
from sigcat.runs.converting.library import IGNORED, UNKNOWN, Reader, channel_table
from sigcat.runs.driver.tables import Target
from sigcat.runs.recording.mcap_trace import CHANNEL, McapFile, Message, Piece, Topics
from sigcat.runs.recording.outside import OutsideValues
from sigcat.runs.recording.trace_file import Lines, Moment, Trace
from sigcat.runs.running.written_input import Span, moment_bytes

_PIECE = 1 << 20


class _Input:
    """The file, and the span of the written rows."""

    def __init__(
        self, file: BinaryIO, by_column: Mapping[str, Sequence[int]], targets: Sequence[Target], outside: OutsideValues
    ) -> None:
        self.file, self.outside, self._by_column, self._targets = file, outside, by_column, targets
        self.span = Span()

    def add(self, moment: Moment) -> None:
        """Write what Python has read."""
        self.outside.look_at(moment)
        self.file.write(moment_bytes(moment, self._by_column, self._targets))
        self.note(moment.time, moment.time, moment.line)

    def note(self, first: int, last: int, line: int) -> None:
        """Note what was written."""
        self.span = Span(first if self.span.first is None else self.span.first, last, line)


def convert_csv(
    file: BinaryIO,
    trace: Trace,
    by_column: Mapping[str, Sequence[int]],
    targets: Sequence[Target],
    library: ctypes.CDLL,
    outside: OutsideValues,
) -> Span:
    """Write a trace in CSV. Raises InputRefused with everything that is wrong with it."""
    columns = zip(trace.columns, trace.shapes, strict=True)
    tables = column_tables([(shape, by_column.get(name, ())) for name, shape in columns])
    reader = Reader(library, tables, [outside.ranges.get(name, NO_RANGE) for name in trace.columns])
    lines, written = Lines(trace), _Input(file, by_column, targets, outside)
    with trace.file.open("rb") as data:
        lines.skip_header(data)
        rest = b""
        while not lines.is_over and (piece := data.read(_PIECE)):
            block = rest + piece
            rest = block[_convert_lines(block, reader, lines, written) :]
            if len(rest) > TRACE_ROW_BYTES:
                break
        if rest and not lines.is_over:
            _add_line(rest[: TRACE_ROW_BYTES + 1], reader, lines, written)
    lines.check()
    _add_outside(reader, trace.columns, outside)
    return written.span


def _add_outside(reader: Reader, columns: Iterable[str], outside: OutsideValues) -> None:
    for column, found in zip(columns, reader.outside, strict=True):
        if found.number:
            outside.add(column, found)


def _convert_lines(block: bytes, reader: Reader, lines: Lines, written: _Input) -> int:
    """Write the whole lines of a block. How many bytes that were."""
    at, state = 0, reader.state
    while not lines.is_over:
        before = state.row_line
        state.lines, state.time = lines.number, lines.last
        read = reader.read_csv(block, at)
        written.file.write(read.data)
        lines.number, lines.last = state.lines, state.time
        if state.row_line != before:
            written.note(state.first, state.time, state.row_line)
        at += read.used
        end = block.find(b"\n", at) + 1 if read.is_left else 0
        if end:
            _add_line(block[at:end], reader, lines, written)
            at = end
        elif not read.used or read.is_left:
            break
    return at


def _add_line(line: bytes, reader: Reader, lines: Lines, written: _Input) -> None:
    moment = lines.moment(line)
    if moment is not None:
        written.add(moment)
        reader.state.time, reader.state.has_row = moment.time, 1
        reader.state.first = written.span.first


# -- MCAP ---------------------------------------------------------------------------------------------------------


def convert_mcap(
    file: BinaryIO, trace: Trace, by_column: Mapping[str, Sequence[int]], targets: Sequence[Target],
    library: ctypes.CDLL | None, outside: OutsideValues,
) -> tuple[Span, tuple[Finding, ...]]:  # fmt: skip
    """Write a trace in MCAP, with notes about it. Raises InputRefused with everything that is wrong with it."""
    written = _Input(file, by_column, targets, outside)
    converting = _Converting(trace, by_column, written, library)
    for piece in converting.file.pieces():
        converting.take(piece)
    converting.flush(None)
    converting.add_outside()
    return written.span, converting.topics.check()


class _Converting:
    def __init__(
        self, trace: Trace, by_column: Mapping[str, Sequence[int]], written: _Input, library: ctypes.CDLL | None
    ) -> None:
        self.file, self.topics = McapFile(trace.file), Topics(trace)
        self._written = written
        self._waiting: list[Message] = []
        columns = [(None, ()), *((shape, by_column.get(name, ())) for name, shape in _columns(trace))]
        self._names = ("", *(name for name, _ in _columns(trace)))
        ranges = [written.outside.ranges.get(name, NO_RANGE) for name in self._names]
        self._reader = Reader(library, column_tables(columns), ranges) if library else None
        self._places = {name: place for place, (name, shape) in enumerate(_columns(trace), 1) if shape}
        self._channels = channel_table()

    def take(self, piece: Piece) -> None:
        """Write a piece; what a later one may precede waits."""
        last = self._reader.is_ordered(piece.data, self._written.span.last or 0) if self._reader else None
        if last is not None and last <= piece.later and not self._waiting:
            self._convert(piece.data)
        else:
            self._waiting = sorted([*self._waiting, *self.file.messages(piece)], key=lambda each: each.time)
            self.flush(piece.later)

    def add_outside(self) -> None:
        """Count the values that the library found outside of their ranges."""
        if self._reader is not None:
            _add_outside(self._reader, self._names, self._written.outside)

    def flush(self, later: int | None) -> None:
        """Write what waits until a time."""
        ready = [each for each in self._waiting if later is None or each.time <= later]
        self._waiting = self._waiting[len(ready) :]
        for message in ready:
            self._add(message)

    def _add(self, message: Message) -> None:
        before = self.topics.values
        moment = self.topics.moment(message)
        if moment is not None:
            self._written.add(moment)
        elif self.topics.values > before:
            self._written.note(message.time, message.time, 0)

    def _convert(self, data: bytes) -> None:
        assert self._reader is not None
        at, state = 0, self._reader.state
        while at < len(data):
            state.has_row = state.has_time = 0
            read = self._reader.read_mcap(self._channels, data, at)
            self._written.file.write(read.data)
            if state.has_row:
                self.topics.values += 1
                self._written.note(state.first, state.time, 0)
            at += read.used
            if read.is_left:
                at = self._take_record(data, at)
            elif not read.used:
                raise self.file.damaged()

    def _take_record(self, data: bytes, at: int) -> int:
        """Take a record that the library leaves, a channel or a message, and return the place of the next one."""
        kind, size = data[at], int.from_bytes(data[at + 1 : at + 9], "little")
        end = at + 9 + size
        if kind == CHANNEL:
            self._channels[self.file.add_channel(data[at + 9 : end])] = UNKNOWN
        for message in self.file.messages(Piece(data[at:end], 0)) if kind != CHANNEL else ():
            self._add(message)
        if kind not in (CHANNEL, 3):
            self._learn(int.from_bytes(data[at + 9 : at + 11], "little"))
        return end

    def _learn(self, channel: int) -> None:
        """From its second message on, the library takes a channel, or skips one without a column."""
        name = self.file.topics.get(channel)
        self._channels[channel] = self._places.get(name, SKIPPED) if name else IGNORED


def _columns(trace: Trace) -> list[tuple[str, Shape | None]]:
    return list(zip(trace.columns, trace.shapes, strict=True))
