"""Lines of a log in Vector's ASC, as python-can's reader takes them."""

import re
from collections.abc import Iterator, Sequence
from decimal import Decimal, InvalidOperation

from sigcat.gateway.frames import Frame, Passed, frame_of
from sigcat.gateway.logs.lines import Lines, TextLines, text_of
from sigcat.gateway.logs.problems import CutLine

_BASE = re.compile(rb"base\s+(hex|dec)(?:\s+timestamps\s+(relative|absolute))?", re.IGNORECASE)
_TIMED = re.compile(rb"\s*(\d+(?:\.\d+)?)(\s.*)", re.DOTALL)
_CLASSIC = re.compile(rb".*\sd\s+([0-8])((?:\s+[0-9A-Fa-f]{1,3})*)\s*", re.DOTALL)
"""A classic frame that ends with its data."""
_WITH_MORE = re.compile(rb".*\s[RrTt]x\s+d\s+([0-8])(\s.*)?", re.DOTALL)
"""A classic frame that may have more behind its data."""
_FD = re.compile(
    rb".*\sCANFD\s+\S+\s+\S+\s+[0-9A-Fa-f]+x?\s+(?:\S+\s+)?[01]\s+[01]\s+[0-9A-Fa-f]\s+(\d{1,2})(\s.*)?", re.DOTALL
)
"""A frame of CAN FD: the length of its data, then that and what follows it."""
_NO_DATA = re.compile(rb".*(?:\s[RrTt]x\s+r(?:\s+\d+)?|ErrorFrame)\s*", re.DOTALL)
_BYTE = {b"hex": re.compile(rb"[0-9A-Fa-f]{2}"), b"dec": re.compile(rb"[0-9]{1,3}")}
_END_OF_HEADER = "no internal events logged\n"
"""A line that ends the header for the reader, which would take the first frame for a part of it."""


class AscLines(TextLines):
    """The lines as the reader takes them. Times that are relative to the line before are added up, which python-can does not."""

    def __init__(self, lines: Lines) -> None:
        super().__init__(lines)
        self._base = b"hex"
        self._is_relative = False
        self._is_past_header = False
        self._waiting = b""
        """The first line after the header, while that is ended."""
        self._time = Decimal(0)

    def __iter__(self) -> Iterator[str]:
        """The lines from where it is. The reader iterates twice: for the header, which it ends at a line that it drops."""
        if self._is_past_header:
            yield _END_OF_HEADER
        while line := self._waiting or next(iter(self.lines), b""):
            if not self._is_past_header and _TIMED.match(line):
                self._waiting, self._is_past_header = line, True
                yield _END_OF_HEADER
            self._waiting = b""
            text_of(line)
            if self._is_past_header:
                self._refuse_cut(line)
            yield text_of(self._read_as(line))

    def _refuse_cut(self, line: bytes) -> None:
        """Raises CutLine for a line that was cut within its data: the reader would take what there is for a value."""
        is_ended = line.endswith(b"\n")
        if frame := _FD.fullmatch(line):
            self._refuse_short(int(frame[1]), (frame[2] or b"").split(), is_ended=False)
        elif frame := _CLASSIC.fullmatch(line) or _WITH_MORE.fullmatch(line):
            self._refuse_short(int(frame[1]), (frame[2] or b"").split(), is_ended=is_ended)
        elif not is_ended and _TIMED.match(line + b" ") and not _NO_DATA.fullmatch(line):
            raise CutLine("it has no line break, and no frame up to its end")

    def _refuse_short(self, count: int, given: Sequence[bytes], *, is_ended: bool) -> None:
        """Raises CutLine for fewer bytes than are announced, and for half ones. The last one may be cut where the line has no end."""
        is_half = 0 < len(given) <= count and len(given[-1]) < 2 and not is_ended
        if len(given) < count or is_half:
            raise CutLine(f"it has {len(given) - is_half} of {count} bytes")
        wrong = next((each for each in given[:count] if not _BYTE[self._base].fullmatch(each)), None)
        if wrong is not None:
            raise CutLine(f"{wrong.decode('latin-1')!r} is not a whole byte")

    def _read_as(self, line: bytes) -> bytes:
        if self._is_relative and (timed := _TIMED.match(line)):
            return self._absolute(timed[1], timed[2])
        if base := _BASE.match(line):
            self._base = base[1].lower()
            self._is_relative = (base[2] or b"").lower() == b"relative"
        return line

    def _absolute(self, time: bytes, rest: bytes) -> bytes:
        try:
            self._time += Decimal(time.decode())
        except InvalidOperation:
            return time + rest
        return str(self._time).encode() + rest


class Asc:
    """The frames of a log. An exception is about one line; iterate again for those after it."""

    def __init__(self, lines: Lines) -> None:
        from can.io import ASCReader

        self._reader = ASCReader(AscLines(lines))  # type: ignore[arg-type]  # it iterates

    def __iter__(self) -> Iterator[Frame | Passed]:
        for message in self._reader:
            yield frame_of(message, first_channel=1)
