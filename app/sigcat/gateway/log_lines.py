"""The lines of a log that is text, as python-can's readers take them: one by one, of a bounded length, and counted."""

import re
from collections.abc import Iterator
from decimal import Decimal, InvalidOperation
from typing import IO

from sigcat.limits import LOG_LINE_BYTES

_BASE = re.compile(rb"base\s+(?:hex|dec)\s+timestamps\s+relative", re.IGNORECASE)
_TIMED = re.compile(rb"\s*(\d+(?:\.\d+)?)(\s.*)", re.DOTALL)
_ERROR = re.compile(rb"(\s*\(\S*\)\s+\S+\s+)[2367AaBbEeFf][0-9A-Fa-f]{7}#")
_BUS_ERROR = b"20000080#0000000000000000\n"
"""An error frame as the reader of candump's logs knows it, which takes those of other kinds for frames of data."""
_HALF_BYTE = re.compile(rb"[^#]*#(?:#[0-9A-Fa-f])?(?:[0-9A-Fa-f]{2})*[0-9A-Fa-f]\s*(?:[RrTt]\s*)?")
"""A line of candump whose data ends in the middle of a byte, which its reader takes for a byte."""
_OF_ASC = re.compile(rb".*\sd\s+([0-8])((?:\s+[0-9A-Fa-f]{1,3})*)\s*", re.DOTALL)
"""A classic frame of ASC that ends with its data."""
_FD_OF_ASC = re.compile(
    rb".*\sCANFD\s+\S+\s+\S+\s+[0-9A-Fa-f]+x?\s+(?:\S+\s+)?[01]\s+[01]\s+[0-9A-Fa-f]\s+(\d{1,2})(\s.*)?", re.DOTALL
)
"""A frame of CAN FD in ASC: the length of its data, then that and what follows it."""
_FD_OF_CANDUMP = re.compile(rb"[^#]*##[0-9A-Fa-f]((?:[0-9A-Fa-f]{2})*)\s*(?:[RrTt]\s*)?")
_FD_LENGTHS = (*range(9), 12, 16, 20, 24, 32, 48, 64)
_DIGITS = 2
_END_OF_HEADER = "no internal events logged\n"
"""A line that ends the header for the reader of ASC, which would take the first frame for a part of it."""


class CutLine(ValueError):
    """A line that was cut within its data."""


class LogLines:
    """An iterator over the lines of a file, which goes on where it was when it is asked again.

    A log in ASC may have times that are relative to the line before, which python-can reads as they stand: here they are
    added up.
    """

    def __init__(self, file: IO[bytes], *, is_asc: bool) -> None:
        self.number = 0
        """Of the line that was read last, from 1."""
        self.is_at_end = False
        self.too_long: list[int] = []
        """Lines that were left out."""
        self._file = file
        self._is_asc = is_asc
        self._is_relative = False
        self._is_past_header = False
        self._waiting = b""
        """The first line after the header, while that is ended."""
        self._time = Decimal(0)

    def __iter__(self) -> Iterator[str]:
        """The lines from where it is. A reader of ASC iterates twice: for the header, which it ends at a line that it drops."""
        if self._is_past_header:
            yield _END_OF_HEADER
        while line := self._waiting or self._line():
            if self._is_asc and not self._is_past_header and _TIMED.match(line):
                self._waiting, self._is_past_header = line, True
                yield _END_OF_HEADER
            self._waiting = b""
            self._refuse_cut(line)
            yield self._read_as(line).decode("latin-1")
        self.is_at_end = True

    def _refuse_cut(self, line: bytes) -> None:
        """Raises CutLine for a line that was cut within its data: readers would take what there is for a value."""
        if b"\0" in line:
            raise CutLine("it has bytes that are no text")
        if not self._is_asc:
            _refuse_cut_of_candump(line)
        elif self._is_past_header and (frame := _FD_OF_ASC.fullmatch(line)):
            _refuse_short(int(frame[1]), (frame[2] or b"").split())
        elif self._is_past_header and (frame := _OF_ASC.fullmatch(line)):
            count, given = int(frame[1]), frame[2].split()
            is_half = bool(given) and len(given[-1]) < _DIGITS and not line.endswith(b"\n")
            if len(given) < count or is_half:
                raise CutLine(f"it has {len(given) - is_half} of {count} bytes")

    def _read_as(self, line: bytes) -> bytes:
        """A line as the reader takes it."""
        if not self._is_asc:
            error = _ERROR.match(line)
            return error[1] + _BUS_ERROR if error else line
        if self._is_relative and (timed := _TIMED.match(line)):
            return self._absolute(timed[1], timed[2])
        if _BASE.match(line):
            self._is_relative = True
        return line

    def read(self, _count: int = -1) -> str:
        """There for readers that look whether this is a file."""
        return ""

    def close(self) -> None:
        """The file is closed where it was opened."""

    def _line(self) -> bytes:
        """The next line that is not too long; nothing at the end."""
        while line := self._file.readline(LOG_LINE_BYTES):
            self.number += 1
            if len(line) < LOG_LINE_BYTES or line.endswith(b"\n"):
                return line
            self.too_long = [*self.too_long, self.number][:10]
            while (rest := self._file.readline(LOG_LINE_BYTES)) and not rest.endswith(b"\n"):
                pass
        return b""

    def _absolute(self, time: bytes, rest: bytes) -> bytes:
        try:
            self._time += Decimal(time.decode())
        except InvalidOperation:
            return time + rest
        return str(self._time).encode() + rest


def _refuse_cut_of_candump(line: bytes) -> None:
    if _HALF_BYTE.fullmatch(line):
        raise CutLine("its data ends in the middle of a byte")
    frame = _FD_OF_CANDUMP.fullmatch(line)
    if frame and len(frame[1]) // _DIGITS not in _FD_LENGTHS:
        raise CutLine(f"{len(frame[1]) // _DIGITS} bytes are no length of a frame of CAN FD")


def _refuse_short(count: int, given: list[bytes]) -> None:
    """What follows the data is more than one number: a frame of which nothing follows was cut in its last byte, or after it."""
    is_half = len(given) == count and bool(given) and len(given[-1]) < _DIGITS
    if len(given) < count or is_half:
        raise CutLine(f"it has {len(given) - is_half} of {count} bytes")
