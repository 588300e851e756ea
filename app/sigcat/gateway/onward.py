"""Rows go to running functions through a player, and every sent value is counted; the values that functions send become a trace."""

import csv
import tempfile
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from threading import Lock
from typing import IO

from sigcat import codes
from sigcat.findings import Finding
from sigcat.gateway.trace import Row
from sigcat.players.player import Player
from sigcat.players.program import Program
from sigcat.runs.recording.cells import Unfit, plain_text, value_of
from sigcat.runs.recording.normalized import normalized_line


class Handed:
    """Input of a player: rows of a normalized trace, in which columns that no function receives are empty."""

    def __init__(self, columns: Sequence[str], program: Program) -> None:
        self.columns = columns
        self.platform = program.platform
        self.counts: Counter[int] = Counter()
        """Values, by their columns."""
        self.unfit: Counter[str] = Counter()
        """Values that are not of the functions' datatype, by their columns."""
        self._reasons: dict[str, str] = {}
        """For the first one of each column."""
        self._shapes = [program.received.get(name) for name in columns]

    def given(self, player: Player, rows: Iterable[Row]) -> Iterator[Row]:
        """Give rows to a player, and yield each. Raises PlayerEnded."""
        for row in rows:
            player.give(normalized_line(row.time, self._cells(row)))
            yield row
        player.finish()

    def _cells(self, row: Row) -> Sequence[str]:
        cells = [""] * len(self.columns)
        for index, text in row.cells.items():
            shape = self._shapes[index]
            try:
                cells[index] = plain_text(value_of(text, shape), shape) if shape else ""
                self.counts[index] += 1
            except Unfit as reason:
                self._reasons.setdefault(self.columns[index], str(reason))
                self.unfit[self.columns[index]] += 1
        return cells

    def line(self, player: Player) -> str:
        """Return the outcome as one line."""
        return f"{player.sent or 0:,} values of {len(self._received(player)):,} signals sent over {self.platform}"

    def findings(self, player: Player, name: str) -> Iterator[Finding]:
        """Return the number of values that were not sent."""
        for column, count in self.unfit.items():
            message = f"{column} {self._reasons[column]}: {count:,} values were not sent."
            yield codes.FUNCTIONS_UNREACHED.finding(message, name)
        unknown = sorted(set(player.unknown))
        if unknown:
            message = f"No function receives {', '.join(unknown[:_MOST])}{' and more' if len(unknown) > _MOST else ''}."
            yield codes.FUNCTIONS_UNREACHED.graded("info").finding(message, name)  # a bus has more than functions need
        expected = sum(self.counts[index] for index in self._received(player))
        if player.sent != expected:
            message = f"Of {expected:,} values, {player.sent or 0:,} were sent over {self.platform}."
            yield codes.FUNCTIONS_UNREACHED.finding(message, name)
        if player.unheard:
            message = f"Of {player.sent or 0:,} values, {player.unheard:,} were sent while a process was gone that functions run in."
            yield codes.FUNCTIONS_UNREACHED.finding(message, name)

    def _received(self, player: Player) -> list[int]:
        """Numbers of columns that a function receives."""
        return [index for index, column in enumerate(self.columns) if column not in player.unknown]


_MOST = 20


class Heard:
    """Values that functions have sent: kept in a file until all columns of their trace are known."""

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
