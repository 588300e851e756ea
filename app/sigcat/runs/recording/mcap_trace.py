"""A trace in MCAP, as `mcap_file` and other tools write it: messages in JSON, in order of time, chunk by chunk."""

import csv
import json
import math
import struct
from array import array
from collections import deque
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager
from io import BytesIO
from pathlib import Path
from typing import Any, BinaryIO, NamedTuple

from sigcat import codes
from sigcat.adapter.host.shapes import Shape, Value
from sigcat.errors import InputRefused, UsageError
from sigcat.findings import Finding, has_errors, shown
from sigcat.limits import TRACE_FINDINGS
from sigcat.names import did_you_mean
from sigcat.runs.recording.cells import Unfit, exact_float, fitted, value_of
from sigcat.runs.recording.times import LATEST, seconds
from sigcat.runs.recording.trace_file import TIME, Known, Moment, Trace, missing_inputs, refused, refused_trace

SUFFIX = ".mcap"
_MAGIC = b"\x89MCAP0\r\n"
_FIX = "Record topics as `sigcat simulate -o FILE.mcap` writes them: a message in JSON, with `value`."
_RECORD = struct.Struct("<BQ")
_MESSAGE = struct.Struct("<HIQQ")
CHANNEL, _MESSAGES, _CHUNK, _FOOTER = 4, 5, 6, 2
_LONGEST_RUN = 1 << 20
"""Bytes of messages outside of chunks that are read at once."""


class Message(NamedTuple):
    """A message of a topic in JSON."""

    time: int
    name: str
    """The topic, as a path."""
    data: bytes


class Piece(NamedTuple):
    """Records of a chunk, or of messages outside of chunks."""

    data: bytes
    later: int
    """No message after this piece is before this time."""


class McapFile:
    """A file, read piece by piece: memory does not grow with its length."""

    def __init__(self, path: Path) -> None:
        """Raise InputRefused, or UsageError without the package `mcap`."""
        try:
            import mcap.records
        except ImportError:
            raise UsageError("MCAP needs the extra `mcap`: run `pip install 'sigcat[mcap]'`") from None
        del mcap
        self.path = path
        self.topics: dict[int, str | None] = {}
        """By channel; None: its messages are not JSON."""
        self._offsets, self._sizes, self._firsts = array("q"), array("q"), array("Q")
        with path.open("rb") as file:
            self._read_structure(file)
        if not self.topics:
            for piece in self.pieces():
                self._add_channels(piece.data)

    def pieces(self) -> Iterator[Piece]:
        """All pieces. Raises InputRefused."""
        later = array("Q", self._firsts)
        for index in range(len(later) - 2, -1, -1):
            later[index] = min(later[index], later[index + 1])
        later.append(LATEST)
        with self.path.open("rb") as file, ThreadPoolExecutor(1) as ahead:
            following = ahead.submit(self._piece, file, 0)
            for index in range(len(self._offsets)):
                data = following.result()
                following = ahead.submit(self._piece, file, index + 1)
                yield Piece(data, later[index + 1])

    def _piece(self, file: BinaryIO, index: int) -> bytes:
        """The records of a piece; none after the last one."""
        if index == len(self._offsets):
            return b""
        file.seek(self._offsets[index])
        data = file.read(self._sizes[index])
        return data if data[0] == _MESSAGES else self._unpacked(data)

    def messages(self, piece: Piece) -> list[Message]:
        """Messages in JSON of a piece, in order of time. Raises InputRefused."""
        found = []
        for kind, begin, end in _records(piece.data):
            if kind == CHANNEL:
                self.add_channel(piece.data[begin:end])
            elif kind == _MESSAGES:
                if end - begin < _MESSAGE.size:
                    raise self.damaged()
                channel, _, time, _ = _MESSAGE.unpack_from(piece.data, begin)
                topic = self.topics.get(channel)
                if topic is not None:
                    found.append(Message(time, topic, piece.data[begin + _MESSAGE.size : end]))
        return sorted(found, key=lambda each: each.time)

    def add_channel(self, data: bytes) -> int:
        """Note the channel of a record, and return its number."""
        from mcap.data_stream import ReadDataStream
        from mcap.records import Channel

        with _damages(self):
            found = Channel.read(ReadDataStream(BytesIO(data)))
        name = found.topic.removeprefix("/").replace("/", ".")
        self.topics[found.id] = name if found.message_encoding == "json" else None
        return int(found.id)

    def damaged(self) -> InputRefused:
        """Say that the file is damaged."""
        return refused_trace(
            self.path, f"The file must be in MCAP: {_why(self.path)}.", "Record it again, or try `mcap recover`."
        )

    def _read_structure(self, file: BinaryIO) -> None:
        """Places of chunks and of messages outside of them; channels outside of chunks."""
        size = self.path.stat().st_size
        at = len(_MAGIC)
        is_whole = file.read(at) == _MAGIC
        while is_whole:
            file.seek(at)
            head = file.read(_RECORD.size)
            is_whole = len(head) == _RECORD.size
            if not is_whole:
                break
            kind, length = _RECORD.unpack(head)
            end = at + _RECORD.size + length
            is_whole = end <= size
            if is_whole and kind == _FOOTER:
                file.seek(end)
                is_whole = file.read(len(_MAGIC)) == _MAGIC
                break
            if not is_whole:
                break
            if kind == CHANNEL:
                self.add_channel(file.read(length))
            elif kind in (_CHUNK, _MESSAGES):
                body = file.read(_MESSAGE.size)
                is_whole = len(body) == _MESSAGE.size
                if is_whole:
                    first = struct.unpack_from("<Q", body, 6 if kind == _MESSAGES else 0)[0]
                    self._add_piece(kind, at, end, first)
            at = end
        if not is_whole:
            raise self.damaged()

    def _add_piece(self, kind: int, begin: int, end: int, first: int) -> None:
        is_next = bool(self._offsets) and self._offsets[-1] + self._sizes[-1] == begin
        if kind == _MESSAGES and is_next and self._is_run and self._sizes[-1] + end - begin <= _LONGEST_RUN:
            self._sizes[-1] += end - begin
            self._firsts[-1] = min(self._firsts[-1], first)
            return
        self._is_run = kind == _MESSAGES
        self._offsets.append(begin)
        self._sizes.append(end - begin)
        self._firsts.append(first)

    _is_run = False

    def _add_channels(self, data: bytes) -> None:
        for kind, begin, end in _records(data):
            if kind == CHANNEL:
                self.add_channel(data[begin:end])

    def _unpacked(self, data: bytes) -> bytes:
        from mcap.data_stream import ReadDataStream
        from mcap.records import Chunk
        from mcap.stream_reader import get_chunk_data_stream

        with _damages(self):
            chunk = Chunk.read(ReadDataStream(BytesIO(data[_RECORD.size :])))
            stream, size = get_chunk_data_stream(chunk, validate_crc=False)
            return stream.read(size)


@contextmanager
def _damages(file: McapFile) -> Iterator[None]:
    """Errors of the package say that the file is damaged."""
    import zstandard
    from mcap.exceptions import McapError

    try:
        yield
    except (McapError, EOFError, ValueError, RuntimeError, struct.error, zstandard.ZstdError):
        raise file.damaged() from None


def _records(data: bytes) -> Iterator[tuple[int, int, int]]:
    """Kinds of records, and where they begin and end."""
    at = 0
    while at + _RECORD.size <= len(data):
        kind, length = _RECORD.unpack_from(data, at)
        at += _RECORD.size
        yield kind, at, min(at + length, len(data))
        at += length


def messages(file: McapFile) -> Iterator[Message]:
    """All messages in JSON, in order of time. Raises InputRefused."""
    waiting: deque[Message] = deque()
    for piece in file.pieces():
        found = file.messages(piece)
        is_sorted = not (waiting and found) or waiting[-1].time <= found[0].time
        waiting.extend(found)
        if not is_sorted:
            waiting = deque(sorted(waiting, key=lambda each: each.time))
        while waiting and waiting[0].time <= piece.later:
            yield waiting.popleft()
    yield from waiting


def _why(path: Path) -> str:
    with path.open("rb") as file:
        begins = file.read(len(_MAGIC)) == _MAGIC
    return "it ends in the middle, or is damaged" if begins else "it does not begin as such a file"


# -- as a trace ---------------------------------------------------------------------------------------------------


def open_mcap(path: Path, known: Known) -> Trace:
    """A trace by its topics. Raises InputRefused, or UsageError without the package."""
    file = McapFile(path)
    names = tuple(dict.fromkeys(name for name in file.topics.values() if name))
    if not names:
        raise refused_trace(path, "The file must have messages in JSON with `value`, and has none.", _FIX)
    findings = tuple(missing_inputs(known, names, str(path)))
    shapes = tuple(known.received.get(name) for name in names)
    return Trace(path, names, shapes, findings, (), None, ends_rows=False, known=known)


class Topics:
    """Messages to values, and findings about them."""

    def __init__(self, trace: Trace) -> None:
        assert trace.known is not None
        self._known, self._path = trace.known, trace.file
        self._findings: list[Finding] = []
        self._seen: set[str] = set()
        self.values = 0
        """Messages with a value."""

    def moment(self, message: Message) -> Moment | None:
        """The value of a message; None if it has none, or it is not received."""
        given = _value(self._path, message)
        if given is None:
            return None
        self.values += 1
        shape = self._known.received.get(message.name)
        if shape is None:
            self._note(message.name)
            return None
        try:
            return Moment(message.time, ((message.name, _fitted(given, shape)),))
        except Unfit as reason:
            at = f"at {seconds(message.time)} s"
            self._add(codes.TRACE_VALUE_UNFIT.finding(
                f"{message.name} {reason}, {at}.", str(self._path), path=message.name, fix=reason.fix
            ))  # fmt: skip
            return None

    def check(self) -> tuple[Finding, ...]:
        """Notes about topics. Raises InputRefused if something is wrong."""
        if not self.values:
            raise refused_trace(self._path, "The file must have messages in JSON with `value`, and has none.", _FIX)
        if has_errors(self._findings):
            raise refused(self._path, tuple(self._findings))
        return tuple(self._findings)

    def _note(self, name: str) -> None:
        if name in self._seen or self._known.others is None:
            return
        self._seen.add(name)
        if name in self._known.others:
            message = f"{name} is left out: {self._known.unused}."
            self._add(codes.TRACE_COLUMN_UNUSED.finding(message, str(self._path)))
            return
        hint = did_you_mean(name, [*self._known.received, *self._known.others])
        message = f"The topic {shown(name)} is neither a signal of the catalogue nor an interface of the functions."
        self._add(codes.TRACE_COLUMN_UNKNOWN.finding(message, str(self._path), fix=hint or "Remove it."))

    def _add(self, finding: Finding) -> None:
        self._findings.append(finding)
        if len(self._findings) >= TRACE_FINDINGS and has_errors(self._findings):
            self.values += 1
            self.check()


def mcap_moments(trace: Trace) -> Iterator[Moment]:
    """Values of a trace, message by message. Raises InputRefused at its end, with everything that was wrong with it."""
    topics = Topics(trace)
    for message in messages(McapFile(trace.file)):
        found = topics.moment(message)
        if found is not None:
            yield found
    topics.check()


def _fitted(given: Any, shape: Shape) -> Value:
    """A value in a shape. Raises Unfit."""
    return value_of(given, shape) if isinstance(given, str) else fitted(given, shape)


def _value(path: Path, message: Message) -> Any:
    """The value of a message, None if it has none: where there is a symbol, it says what the number means; null is NaN."""
    try:
        found = json.loads(message.data, parse_float=exact_float)
    except (ValueError, RecursionError):
        text = f"A message of {shown(f'/{message.name}')} must be JSON, at {seconds(message.time)} s."
        raise refused_trace(path, text, _FIX) from None
    if not isinstance(found, dict) or "value" not in found:
        return None
    symbol = found.get("symbol")
    return symbol if isinstance(symbol, str) else _with_nan(found["value"])


def _with_nan(value: Any) -> Any:
    if isinstance(value, list):
        return [_with_nan(each) for each in value]
    if isinstance(value, dict):
        return {name: _with_nan(each) for name, each in value.items()}
    return math.nan if value is None else value


def _cell(path: Path, message: Message) -> str | None:
    """Its value as a cell of CSV."""
    value = _value(path, message)
    if isinstance(value, float) and math.isnan(value):
        return "nan"
    return value if value is None or isinstance(value, str) else json.dumps(value)


# -- as CSV -------------------------------------------------------------------------------------------------------


def as_csv(path: Path, folder: Path) -> Path:
    """A trace as it is, or, of one in MCAP, the same as CSV in a folder. Raises InputRefused, or UsageError without the package."""
    if path.suffix.lower() != SUFFIX:
        return path
    names = dict.fromkeys(name for _, name, _ in _cells(path))
    if not names:
        raise refused_trace(path, "The file must have messages in JSON with `value`, and has none.", _FIX)
    target = folder / f"{path.name}.csv"
    with target.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow([TIME, *names])
        for time, cells in _rows(path):
            writer.writerow([seconds(time), *(cells.get(name, "") for name in names)])
    return target


def _cells(path: Path) -> Iterator[tuple[int, str, str]]:
    for message in messages(McapFile(path)):
        cell = _cell(path, message)
        if cell is not None:
            yield message.time, message.name, cell


def _rows(path: Path) -> Iterator[tuple[int, dict[str, str]]]:
    """Yield values of the same time as one row; a value that is repeated then is in a row after it."""
    last, cells = -1, dict[str, str]()
    for time, name, cell in _cells(path):
        if cells and (time != last or name in cells):
            yield last, cells
            cells = {}
        last, cells[name] = time, cell
    if cells:
        yield last, cells
