"""candump's lines as frames. A frame of classic CAN, as candump writes it, is read here, since python-can takes most of the time of
the gateway for it; python-can reads every other line."""

import re
from binascii import unhexlify
from collections.abc import Iterator
from io import StringIO

from sigcat.gateway.frames import Frame, Passed, frame_of
from sigcat.gateway.logs.lines import Lines, text_of
from sigcat.gateway.logs.problems import CutLine

_CLASSIC = re.compile(
    rb"\((\d{1,10})\.(\d{6})\) (\S+) ([0-9A-Fa-f]{3}|[01][0-9A-Fa-f]{7})#((?:[0-9A-Fa-f]{2}){0,8})(?: [RT])?\r?\n?"
)
_ERROR = re.compile(rb"(\s*\(\S*\)\s+\S+\s+)[2367AaBbEeFf][0-9A-Fa-f]{7}#")
_BUS_ERROR = b"20000080#0000000000000000\n"
"""An error frame as python-can knows it, which takes those of other kinds for frames of data."""
_HALF_BYTE = re.compile(rb"[^#]*#(?:#[0-9A-Fa-f])?(?:[0-9A-Fa-f]{2})*[0-9A-Fa-f]\s*(?:[RrTt]\s*)?")
"""A line whose data ends in the middle of a byte, which python-can takes for a byte."""
_FD = re.compile(rb"[^#]*##[0-9A-Fa-f]((?:[0-9A-Fa-f]{2})*)\s*(?:[RrTt]\s*)?")
_FD_LENGTHS = (*range(9), 12, 16, 20, 24, 32, 48, 64)
_EXTENDED = 8
"""Digits of an extended identifier."""


class Candump:
    """The frames of a log. An exception is about one line; iterate again for those after it."""

    def __init__(self, lines: Lines) -> None:
        self._lines = lines

    def __iter__(self) -> Iterator[Frame | Passed]:
        channels: dict[bytes, str] = {}
        for line in self._lines:
            match = _CLASSIC.fullmatch(line)
            if match is None:
                yield from _unusual(line)
                continue
            seconds, fraction, channel, identifier, data = match.groups()
            yield Frame(
                int(seconds + fraction) * 1000, int(identifier, 16), len(identifier) == _EXTENDED, unhexlify(data),
                channels.get(channel) or channels.setdefault(channel, _channel(channel)),
            )  # fmt: skip


def _channel(name: bytes) -> str:
    """The name of a channel, as python-can has it: a number without leading zeros."""
    text = name.decode("latin-1")
    return str(int(text)) if text.isdecimal() else text


def _unusual(line: bytes) -> Iterator[Frame | Passed]:
    from can.io import CanutilsLogReader

    if _HALF_BYTE.fullmatch(line):
        raise CutLine("its data ends in the middle of a byte")
    frame = _FD.fullmatch(line)
    if frame and len(frame[1]) // 2 not in _FD_LENGTHS:
        raise CutLine(f"{len(frame[1]) // 2} bytes are not a valid length of a CAN FD frame")
    error = _ERROR.match(line)
    text = text_of(error[1] + _BUS_ERROR if error else line)
    yield from map(frame_of, CanutilsLogReader(StringIO(text)))
