"""Answers that wait in memory until clients read them: bounded in all, so that clients that read nothing do not fill it."""

from collections import Counter
from typing import Protocol


class Answering(Protocol):
    """A connection with an answer."""

    @property
    def unread(self) -> int:
        """Bytes that its client has yet to read."""

    def cut_off(self) -> None:
        """End it, whatever of its answer is missing."""


class UnreadAnswers:
    """Beyond the bound, the client that left most unread loses what it left longest."""

    def __init__(self, most_bytes: int) -> None:
        self._most_bytes = most_bytes
        self._clients: dict[Answering, str] = {}
        """Clients of connections with unread data; the connection that has had it longest is first."""

    def add(self, connection: Answering, client: str) -> None:
        """Note that an answer is not read at once."""
        self._clients.setdefault(connection, client)
        unread = {each: each.unread for each in self._clients}
        while sum(unread.values()) > self._most_bytes:
            cut = self._longest_of_most(unread)
            del unread[cut], self._clients[cut]
            cut.cut_off()

    def remove(self, connection: Answering) -> None:
        """Forget a connection: all was read, or the client is gone."""
        self._clients.pop(connection, None)

    def _longest_of_most(self, unread: dict[Answering, int]) -> Answering:
        by_client: Counter[str] = Counter()
        for connection, size in unread.items():
            by_client[self._clients[connection]] += size
        most = max(by_client, key=by_client.__getitem__)
        return next(each for each in unread if self._clients[each] == most)
