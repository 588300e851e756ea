"""Starts of requests: a few of each client in each round of the event loop, so that many of one do not block others."""

import asyncio
from collections import Counter, deque
from collections.abc import Callable

_AT_ONCE = 32
"""Requests of one client that begin before the others have a round; after half of them one is due."""
_IN_ROUND = 2
"""Requests of a client in a round. Most answers are made on the event loop: another client waits ten rounds."""

Start = Callable[[], None]


class RequestStarts:
    """Begins what a client asks for at once, or in one of the next rounds. For one event loop."""

    def __init__(self) -> None:
        self._begun: Counter[str] = Counter()
        """Since the last round, by client. There is one only where a client asks for much: each costs some microseconds."""
        self._waiting: dict[str, deque[Start]] = {}
        self._has_next_round = False

    def add(self, client: str, start: Start) -> None:
        """Begin a request of a client, or have it wait behind others of the same client."""
        if client in self._waiting or self._begun[client] >= _AT_ONCE:
            self._waiting.setdefault(client, deque()).append(start)
            self._expect_round()
            return
        self._begun[client] += 1
        if self._begun[client] * 2 >= _AT_ONCE or len(self._begun) >= _AT_ONCE:
            self._expect_round()
        start()

    def _expect_round(self) -> None:
        if not self._has_next_round:
            self._has_next_round = True
            asyncio.get_running_loop().call_soon(self._round)

    def _round(self) -> None:
        self._has_next_round = False
        self._begun.clear()
        for client, starts in tuple(self._waiting.items()):
            for _ in range(min(len(starts), _IN_ROUND)):
                starts.popleft()()
            if not starts:
                del self._waiting[client]
        if self._waiting:
            self._expect_round()
