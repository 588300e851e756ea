"""Values that a player receives from functions become a trace: kept in a file until all its columns are known."""

import csv
import tempfile
from collections.abc import Iterator
from threading import Lock
from typing import IO

from sigcat.gateway.trace import Row


class Heard:
    """Values that functions have sent."""

    def __init__(self) -> None:
        self.columns: dict[str, int] = {}
        """Names, with their numbers."""
        self.count = 0
        self._file: IO[str] = tempfile.TemporaryFile("w+", encoding="utf-8", newline="")  # noqa: SIM115 - goes with this
        self._writer = csv.writer(self._file)
        self._lock = Lock()

    def take(self, time: int, name: str, text: str) -> None:
        """A value has come; from any thread."""
        with self._lock:
            self.count += 1
            self._writer.writerow((time, self.columns.setdefault(name, len(self.columns)), text))

    def rows(self) -> Iterator[Row]:
        """The rows of the trace, when nothing comes any more. What came late counts as of the time of the row above."""
        self._file.seek(0)
        last = 0
        for time, number, text in csv.reader(self._file):
            last = max(last, int(time))
            yield Row(last, {int(number): text})
