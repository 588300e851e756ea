"""Proposals of near names, as many as anybody reads."""

from collections.abc import Iterable

from sigcat.names import did_you_mean

MOST_HINTS = 100


class Hints:
    """The first hundred problems get a proposal: a search among many names costs milliseconds."""

    def __init__(self) -> None:
        self._left = MOST_HINTS

    def __call__(self, name: str, candidates: Iterable[str]) -> str:
        """A sentence that proposes the nearest names, or nothing."""
        self._left -= 1
        return did_you_mean(name, candidates) if self._left >= 0 else ""
