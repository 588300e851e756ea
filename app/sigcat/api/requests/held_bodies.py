"""Bytes of bodies that the service holds for all requests: clients that stall must not fill its memory."""

from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from sigcat.api.work.quotas import Quota
from sigcat.api.work.refusals import BeyondShare, Busy

_SHARE = 4
"""One client may hold this part of all, so that several have to come together to keep others out."""

Hold = Callable[[int], None]
"""Counts bytes that have arrived. Raises Busy where they are too many."""


class HeldBodies:
    """Counts bytes from their arrival until the request is answered."""

    def __init__(self, most: int) -> None:
        self._most = most
        self._by_client: Counter[str] = Counter()

    def quota_of(self, client: str) -> Quota:
        """The share of a client."""
        most = self._most // _SHARE

        def remaining() -> int:
            return min(self._most - self._by_client.total(), most - self._by_client[client])

        return Quota("bodies", "content-bytes", most, remaining)

    @contextmanager
    def of(self, client: str) -> Iterator[Hold]:
        """Bytes of one request of a client; they are given back in the end."""
        held = 0

        def hold(size: int) -> None:
            nonlocal held
            if self._by_client.total() + size > self._most:
                raise Busy(f"The service holds {self._most:,} bytes of bodies already. Try again later.")
            if self._by_client[client] + size > self._most // _SHARE:
                share = f"{self._most // _SHARE:,} bytes of bodies"
                raise BeyondShare(f"One client may have {share} under way. Try again later.")
            held += size
            self._by_client[client] += size

        try:
            yield hold
        finally:
            self._by_client[client] -= held
            if not self._by_client[client]:
                del self._by_client[client]
