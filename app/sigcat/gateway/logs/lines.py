"""The lines of a log that is text: one by one, of a bounded length, and counted."""

from collections.abc import Iterator
from typing import IO

from sigcat.gateway.logs.problems import CutLine
from sigcat.limits import LOG_LINE_BYTES


class Lines:
    """An iterator over the lines of a file, which continues where it was when it is iterated again."""

    def __init__(self, file: IO[bytes]) -> None:
        self.number = 0
        """Of the line that was read last, from 1."""
        self.is_at_end = False
        self.is_whole = True
        """Whether the line that was read last has a line break."""
        self.too_long: list[int] = []
        """Lines that were skipped."""
        self._file = file

    def __iter__(self) -> Iterator[bytes]:
        while line := self.line():
            yield line
        self.is_at_end = True

    def line(self) -> bytes:
        """The next line that is not too long; nothing at the end. Raises CutLine for one with bytes that are not text."""
        while line := self._file.readline(LOG_LINE_BYTES):
            self.number += 1
            if len(line) < LOG_LINE_BYTES or line.endswith(b"\n"):
                self.is_whole = line.endswith(b"\n")
                if b"\0" in line:
                    raise CutLine("it has bytes that are no text")
                return line
            self.too_long = [*self.too_long, self.number][:10]
            while (rest := self._file.readline(LOG_LINE_BYTES)) and not rest.endswith(b"\n"):
                pass
        return b""


class TextLines:
    """Lines as a reader of python-can takes them."""

    def __init__(self, lines: Lines) -> None:
        self.lines = lines

    def __iter__(self) -> Iterator[str]:
        for line in self.lines:
            yield line.decode("latin-1")

    def read(self, _count: int = -1) -> str:
        """There for readers that look whether this is a file."""
        return ""

    def close(self) -> None:
        """The file is closed where it was opened."""
