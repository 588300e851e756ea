"""Received and sent values as MCAP, which Foxglove and PlotJuggler open: a topic for each signal, messages in JSON.

The records come from the package `mcap`; chunks are made here, of whole blocks of messages.
"""

import json
import struct
import zlib
from collections.abc import Callable, Mapping, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any, BinaryIO, NamedTuple

from sigcat.adapter.host.shapes import Array, Number, Shape, Value
from sigcat.errors import UsageError
from sigcat.runs.recording.cells import json_text

CHUNK_BYTES = 1 << 20
_MAGIC = b"\x89MCAP0\r\n"
_MESSAGE = struct.Struct("<BQHIQQ")
"""Opcode, length, channel, sequence, and the time twice."""
_LENGTH = struct.Struct("<BQ")
_FOOTER = struct.Struct("<BQQQ")
_CALL = {
    "type": "object",
    "title": "Call",
    "properties": {"time": {"type": "number", "description": "When it ended, in s."}},
}


def check_mcap() -> None:
    """Raise UsageError if the package `mcap` is missing."""
    try:
        import mcap.records
    except ImportError:
        raise UsageError("MCAP needs the extra `mcap`: run `pip install 'sigcat[mcap]'`") from None
    del mcap


class McapFile:
    """A file that messages are added to, in order of time. The same messages give the same bytes."""

    def __init__(self, file: BinaryIO, topics: Mapping[str, Shape | None], units: Mapping[str, str]) -> None:
        """Topics are signals with their shapes, and calls without one."""
        from mcap.data_stream import RecordBuilder
        from mcap.records import Channel, Header, Schema

        self._file, self._builder = file, RecordBuilder()
        self._at = 0
        self._messages = bytearray()
        self._maker = ThreadPoolExecutor(1)
        self._made: Future[_Packed] | None = None
        self._chunks: list[bytes] = []
        self._counts: dict[int, int] = {}
        self._first: int | None = None
        self._last = 0
        self.channels = {name: index for index, name in enumerate(topics, 1)}
        """Numbers of topics."""
        self.indexes: Callable[[bytes], list[tuple[int, bytes]]] = indexes_of
        """The function that finds times and places of messages, by channel."""
        self._write(_MAGIC)
        Header(profile="", library="sigcat").write(self._builder)
        for name, index in self.channels.items():
            shape = topics[name]
            data = json.dumps(_schema(name, shape, units) if shape else _CALL, ensure_ascii=False).encode()
            Schema(id=index, name=name, encoding="jsonschema", data=data).write(self._builder)
            topic = f"/{name.replace('.', '/')}"
            Channel(id=index, topic=topic, message_encoding="json", schema_id=index, metadata={}).write(self._builder)
        self._records = self._ended()
        self._write(self._records)

    def add(self, name: str, time: int, text: str) -> None:
        """Add a message of JSON."""
        data = text.encode()
        self.add_records(_MESSAGE.pack(5, 22 + len(data), self.channels[name], 0, time, time) + data)

    def add_records(self, messages: bytes) -> None:
        """Add records of messages."""
        self._messages += messages
        if len(self._messages) >= CHUNK_BYTES:
            self._flush()

    def _flush(self) -> None:
        """Let a chunk be made of the messages since the last one, and write the one before it."""
        data, self._messages = bytes(self._messages), bytearray()
        before, self._made = self._made, self._maker.submit(_packed, data, self.indexes) if data else None
        if before is not None:
            self._add_chunk(before.result())

    def _add_chunk(self, made: "_Packed") -> None:
        """Write a chunk of records of messages, with the times and places of the messages of each channel."""
        from mcap.records import Chunk, ChunkIndex

        indexes, data = made.indexes, made.data
        first = min(_times(entries)[0] for _, entries in indexes)
        last = max(_times(entries)[1] for _, entries in indexes)
        Chunk("zstd", data, last, first, made.checksum, made.size).write(self._builder)
        begin, chunk = self._at, self._ended()
        self._write(chunk)
        places, before = {}, self._at
        for channel, entries in indexes:
            places[channel] = self._at
            self._write(_LENGTH.pack(7, 6 + len(entries)) + struct.pack("<HI", channel, len(entries)) + entries)
            self._counts[channel] = self._counts.get(channel, 0) + len(entries) // 16
        ChunkIndex(
            chunk_length=len(chunk), chunk_start_offset=begin, compression="zstd", compressed_size=len(data),
            message_end_time=last, message_start_time=first, message_index_length=self._at - before,
            message_index_offsets=places, uncompressed_size=made.size,
        ).write(self._builder)  # fmt: skip
        self._chunks.append(self._ended())
        self._first, self._last = first if self._first is None else min(self._first, first), max(self._last, last)

    def finish(self) -> None:
        """Write the rest and the summary."""
        from mcap.records import DataEnd, Statistics

        self._flush()
        self._flush()
        self._maker.shutdown()
        DataEnd(0).write(self._builder)
        self._write(self._ended())
        begin = self._at
        total = len(self.channels)
        Statistics(
            attachment_count=0, channel_count=total, channel_message_counts=self._counts, chunk_count=len(self._chunks),
            message_count=sum(self._counts.values()), message_end_time=self._last, message_start_time=self._first or 0,
            metadata_count=0, schema_count=total,
        ).write(self._builder)  # fmt: skip
        parts = (_after_header(self._records), self._ended(), *self._chunks)
        crc = 0
        for part in parts:
            self._write(part)
            crc = zlib.crc32(part, crc)
        footer = _FOOTER.pack(2, 20, begin, 0)
        self._write(footer + struct.pack("<I", zlib.crc32(footer, crc)) + _MAGIC)

    def _ended(self) -> bytes:
        """The records since the last time."""
        return bytes(self._builder.end())  # type: ignore[no-untyped-call]

    def _write(self, data: bytes) -> None:
        self._file.write(data)
        self._at += len(data)


class _Packed(NamedTuple):
    """Messages, compressed."""

    data: bytes
    size: int
    checksum: int
    indexes: Sequence[tuple[int, bytes]]


def _packed(messages: bytes, indexes: Callable[[bytes], Sequence[tuple[int, bytes]]]) -> _Packed:
    import zstandard

    return _Packed(zstandard.compress(messages, 1), len(messages), zlib.crc32(messages), indexes(messages))


def _after_header(records: bytes) -> bytes:
    """Records of schemas and channels."""
    _, length = _LENGTH.unpack_from(records)
    return records[_LENGTH.size + length :]


def indexes_of(data: bytes) -> list[tuple[int, bytes]]:
    """Times and places of messages, by channel."""
    found: dict[int, bytearray] = {}
    at = 0
    while at < len(data):
        _, length, channel, _, time, _ = _MESSAGE.unpack_from(data, at)
        found.setdefault(channel, bytearray()).extend(struct.pack("<QQ", time, at))
        at += _LENGTH.size + length
    return [(channel, bytes(entries)) for channel, entries in sorted(found.items())]


def _times(entries: bytes) -> tuple[int, int]:
    """Times of the first and the last entry."""
    return struct.unpack_from("<Q", entries)[0], struct.unpack_from("<Q", entries, len(entries) - 16)[0]


# -- messages -----------------------------------------------------------------------------------------------------


def message_text(value: Value, shape: Shape) -> str:
    """`value`, and the symbol of an enumeration beside its number."""
    if isinstance(shape, Number) and shape.symbols:
        symbol = next((symbol for symbol, number in shape.symbols if number == value), None)
        return f'{{"value":{value},"symbol":{json.dumps(symbol)}}}'
    return f'{{"value":{json_text(value, _plain(shape), null="null")}}}'


def call_text(time: int) -> str:
    """The message of a call."""
    return f'{{"time":{json.dumps(time / 10**9)}}}'


def _plain(shape: Shape) -> Shape:
    """A shape without symbols: numbers alone."""
    if isinstance(shape, Number):
        return Number(shape.datatype)
    if isinstance(shape, Array):
        return Array(_plain(shape.element), shape.length)
    return shape._replace(fields=tuple((name, _plain(field)) for name, field in shape.fields))


def _schema(name: str, shape: Shape, units: Mapping[str, str]) -> dict[str, Any]:
    value = _type(shape)
    if name in units:
        value["description"] = f"In {units[name]}."
    properties = {"value": value}
    if isinstance(shape, Number) and shape.symbols:
        properties["symbol"] = {"type": "string", "enum": [symbol for symbol, _ in shape.symbols]}
    return {"type": "object", "title": name, "properties": properties}


def _type(shape: Shape) -> dict[str, Any]:
    if isinstance(shape, Array):
        return {"type": "array", "items": _type(shape.element)}
    if isinstance(shape, Number):
        kind = "boolean" if shape.datatype == "boolean" else "integer" if shape.is_whole else "number"
        return {"type": kind}
    return {"type": "object", "properties": {name: _type(field) for name, field in shape.fields}}
