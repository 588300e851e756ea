"""Proposals of near names, as many as anybody reads."""

from collections.abc import Iterable

from sigcat.limits import PROPOSALS
from sigcat.names import did_you_mean


class Hints:
    """The first hundred problems get a proposal: a search among many names costs milliseconds."""

    def __init__(self) -> None:
        self._left = PROPOSALS

    def __call__(self, name: str, candidates: Iterable[str]) -> str:
        """A sentence that proposes the nearest names, or nothing."""
        self._left -= 1
        return did_you_mean(name, candidates) if self._left >= 0 else ""
