"""A BLF log, read with python-can: here are the bounds that its reader lacks, of the bytes that one container may unpack to,
and whether the log ends before it says that it does.
"""

import struct
import zlib
from collections.abc import Iterator
from io import BufferedReader
from typing import Any

from can.io import BLFReader
from can.io.blf import LOG_CONTAINER, LOG_CONTAINER_STRUCT, OBJ_HEADER_BASE_STRUCT, ZLIB_DEFLATE, BLFParseError

from sigcat.limits import LOG_CONTAINER_BYTES

_PADDING = 4


class BlfLog:
    """The messages of a log. Iterating raises ValueError, struct.error or zlib.error where it cannot be read on."""

    def __init__(self, file: BufferedReader) -> None:
        try:
            self._reader = BLFReader(file)
        except BLFParseError as error:
            raise ValueError(str(error) or "it does not begin as a BLF log") from None
        self._file = file
        self.expected = self._reader.file_size
        """Bytes that the log says that it has; 0 if it was never closed."""
        self.count = file.tell()
        """Bytes that were read."""

    @property
    def is_cut(self) -> bool:
        """Whether a part is missing at its end. A log that was never closed does not say how much it has."""
        return bool(self.count + _PADDING < self.expected)

    def __iter__(self) -> Iterator[Any]:
        while head := self._file.read(OBJ_HEADER_BASE_STRUCT.size):
            signature, _, _, size, kind = OBJ_HEADER_BASE_STRUCT.unpack(head)
            if signature != b"LOBJ" or size < OBJ_HEADER_BASE_STRUCT.size:
                raise ValueError("what follows is no object of a log")
            if size > LOG_CONTAINER_BYTES:
                raise ValueError(f"an object has {size:,} bytes")
            body = self._file.read(size - OBJ_HEADER_BASE_STRUCT.size)
            self.count += len(head) + len(body) + len(self._file.read(size % 4))
            if kind == LOG_CONTAINER:
                yield from self._messages(body)

    def _messages(self, body: bytes) -> Iterator[Any]:
        method, _ = LOG_CONTAINER_STRUCT.unpack_from(body)
        data = body[LOG_CONTAINER_STRUCT.size :]
        if method == ZLIB_DEFLATE:
            unpacking = zlib.decompressobj()
            data = unpacking.decompress(data, LOG_CONTAINER_BYTES)
            if unpacking.unconsumed_tail:
                raise ValueError(f"a container unpacks to more than {LOG_CONTAINER_BYTES:,} bytes")
        try:
            yield from self._reader._parse_container(data)  # noqa: SLF001 — the loop around it is here
        except BLFParseError as error:
            raise ValueError(str(error) or "an object is missing") from None
        except IndexError as error:
            raise struct.error(str(error)) from None
        if len(self._reader._tail) > LOG_CONTAINER_BYTES:  # noqa: SLF001 — what an object without an end would grow to
            raise ValueError("an object has no end")
