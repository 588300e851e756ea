"""When requests begin: in each round of the event loop a few of each client, so that many of one are no wall before those of others."""

import asyncio
from collections import Counter, deque
from collections.abc import Callable

_IN_ROUND = 2
"""Of one client. Most answers are made on the event loop, and an ordinary request of another one takes about ten rounds of it."""

Start = Callable[[], None]


class RequestStarts:
    """Begins what a client asks for at once, or in one of the next rounds. For one event loop."""

    def __init__(self) -> None:
        self._begun: Counter[str] = Counter()
        """In this round, by client."""
        self._waiting: dict[str, deque[Start]] = {}

    def add(self, client: str, start: Start) -> None:
        """Begin a request of a client, those before it first."""
        if not self._begun:
            asyncio.get_running_loop().call_soon(self._next_round)
        if self._begun[client] < _IN_ROUND:
            self._begun[client] += 1
            start()
        else:
            self._waiting.setdefault(client, deque()).append(start)

    def _next_round(self) -> None:
        self._begun.clear()
        waiting, self._waiting = self._waiting, {}
        for client, starts in waiting.items():
            for _ in range(min(len(starts), _IN_ROUND)):
                self.add(client, starts.popleft())
            if starts:
                self._waiting[client] = starts
