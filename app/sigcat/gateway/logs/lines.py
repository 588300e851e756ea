"""The lines of a log that is text: one by one, of a bounded length, and counted."""

from collections.abc import Iterator
from typing import IO

from sigcat.gateway.logs.problems import CutLine
from sigcat.limits import LOG_LINE_BYTES


class Lines:
    """An iterator over the lines of a file, which continues where it was when it is iterated again."""

    def __init__(self, file: IO[bytes]) -> None:
        self.number = 0
        """Number of the line that was read last, from 1."""
        self.is_at_end = False
        self.is_whole = True
        """Whether the line that was read last has a line break."""
        self.too_long: list[int] = []
        """Lines that were skipped."""
        self._file = file

    def __iter__(self) -> Iterator[bytes]:
        file = self._file
        while line := file.readline(LOG_LINE_BYTES):
            self.number += 1
            if line.endswith(b"\n"):
                yield line
            elif self._is_last(line):
                self.is_whole = False
                yield line
        self.is_at_end = True

    def _is_last(self, line: bytes) -> bool:
        """Whether a line without a line break is the last one; else it is too long, and its rest is skipped."""
        if len(line) < LOG_LINE_BYTES:
            return True
        self.too_long = [*self.too_long, self.number][:10]
        while (rest := self._file.readline(LOG_LINE_BYTES)) and not rest.endswith(b"\n"):
            pass
        return False


class TextLines:
    """Lines as a reader of python-can takes them."""

    def __init__(self, lines: Lines) -> None:
        self.lines = lines

    def __iter__(self) -> Iterator[str]:
        return map(text_of, self.lines)

    def read(self, _count: int = -1) -> str:
        """There for readers that look whether this is a file."""
        return ""

    def close(self) -> None:
        """The file is closed where it was opened."""


def text_of(line: bytes) -> str:
    """A line as text. Raises CutLine for one with bytes that are not text."""
    if b"\0" in line:
        raise CutLine("it has bytes that are not text")
    return line.decode("latin-1")
