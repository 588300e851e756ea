"""A BLF log, read with python-can: here are the bounds that its reader lacks, of the bytes that one container may unpack to,
and whether the log ends before it says that it does.
"""

import struct
import zlib
from collections.abc import Iterator
from io import BufferedReader
from typing import Any

from can.io import BLFReader
from can.io.blf import (
    FILE_HEADER_STRUCT,
    LOG_CONTAINER,
    LOG_CONTAINER_STRUCT,
    OBJ_HEADER_BASE_STRUCT,
    ZLIB_DEFLATE,
    BLFParseError,
)

from sigcat.gateway.logs.problems import CutLog, DamagedLog, NoLog
from sigcat.limits import LOG_CONTAINER_BYTES

_SIGNATURE = b"LOGG"
_BEGIN = struct.Struct("<4sI")
"""Signature of a log, and the size of its header."""
_PADDING = 4


class BlfLog:
    """The messages of a log. Making it raises NoLog, CutLog or DamagedLog, iterating the latter two."""

    def __init__(self, file: BufferedReader) -> None:
        _check_header(file.peek(_BEGIN.size)[: _BEGIN.size])
        try:
            self._reader = BLFReader(file)
        except (struct.error, BLFParseError):
            raise CutLog("its header is not whole") from None
        self._file = file
        self._expected = self._reader.file_size
        """Bytes that the log says that it has; 0 if it was never closed."""
        self._count = file.tell()
        """Bytes that were read."""

    def __iter__(self) -> Iterator[Any]:
        while head := self._file.read(OBJ_HEADER_BASE_STRUCT.size):
            kind, size = _object(head)
            body = self._file.read(size)
            self._count += len(head) + len(body) + len(self._file.read(size % 4))
            if kind == LOG_CONTAINER:
                yield from self._messages(body)
            if len(body) < size:
                break
        if self._count + _PADDING < self._expected:
            raise CutLog(f"it has {self._count:,} of {self._expected:,} bytes")
        if head:
            raise CutLog("its last object is not whole")

    def _messages(self, body: bytes) -> Iterator[Any]:
        """Bytes of a container, as far as they are there."""
        if len(body) < LOG_CONTAINER_STRUCT.size:
            return
        method, _ = LOG_CONTAINER_STRUCT.unpack_from(body)
        data = body[LOG_CONTAINER_STRUCT.size :]
        if method == ZLIB_DEFLATE:
            data = _unpacked(data)
        try:
            yield from self._reader._parse_container(data)  # noqa: SLF001 — the loop around it is here
        except (BLFParseError, IndexError):
            raise DamagedLog("an object is missing") from None
        if len(self._reader._tail) > LOG_CONTAINER_BYTES:  # noqa: SLF001 — what an object without an end would grow to
            raise DamagedLog("an object has no end")


def _check_header(begin: bytes) -> None:
    if not begin:
        raise NoLog("it is empty")
    if not begin.startswith(_SIGNATURE):
        raise NoLog("it does not begin as one")
    if len(begin) < _BEGIN.size:
        raise CutLog("its header is not whole")
    size = _BEGIN.unpack(begin)[1]
    if not FILE_HEADER_STRUCT.size <= size <= LOG_CONTAINER_BYTES:
        raise DamagedLog(f"its header says that it has {size:,} bytes")


def _object(head: bytes) -> tuple[int, int]:
    """The kind of an object, and the bytes that follow its header."""
    if len(head) < OBJ_HEADER_BASE_STRUCT.size:
        raise CutLog("its last object is not whole")
    signature, _, _, size, kind = OBJ_HEADER_BASE_STRUCT.unpack(head)
    if signature != b"LOBJ" or size < OBJ_HEADER_BASE_STRUCT.size:
        raise DamagedLog("there is something else where an object has to begin")
    if size > LOG_CONTAINER_BYTES:
        raise DamagedLog(f"an object says that it has {size:,} bytes")
    return kind, size - OBJ_HEADER_BASE_STRUCT.size


def _unpacked(data: bytes) -> bytes:
    unpacking = zlib.decompressobj()
    try:
        unpacked = unpacking.decompress(data, LOG_CONTAINER_BYTES)
    except zlib.error:
        raise DamagedLog("a container of it cannot be unpacked") from None
    if unpacking.unconsumed_tail:
        raise DamagedLog(f"a container unpacks to more than {LOG_CONTAINER_BYTES:,} bytes")
    return unpacked
