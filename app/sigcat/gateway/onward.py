"""Rows go to running functions through a player, and every sent value is counted."""

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence

from sigcat import codes
from sigcat.findings import Finding
from sigcat.gateway.trace import Row
from sigcat.players.player import Player


class Handed:
    """Input of a player."""

    def __init__(self, columns: Sequence[str], platform: str) -> None:
        self.columns = columns
        self.platform = platform
        self.counts: Counter[int] = Counter()
        """Values, by their columns."""

    def counted(self, rows: Iterable[Row]) -> Iterator[Row]:
        """The rows, as they are."""
        for row in rows:
            self.counts.update(row.cells.keys())
            yield row

    def line(self, player: Player) -> str:
        """Return the outcome as one line."""
        return f"{player.sent or 0:,} values of {len(self._received(player)):,} signals sent over {self.platform}"

    def findings(self, player: Player, name: str) -> Iterator[Finding]:
        """Return the number of values that were not sent."""
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
