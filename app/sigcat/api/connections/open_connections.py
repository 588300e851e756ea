"""The connections that a process has open: bounded in all and for each client, so that none keeps others out.

Room for a new one is made by closing the one that has waited longest for its client: for the rest of a request, or for the next
one. A request that the service works on is never given up for it.
"""

from collections import OrderedDict
from collections.abc import Callable
from typing import Protocol

from sigcat.api.client_network import network_of


class Connection(Protocol):
    """Interface that a connection must have."""

    @property
    def waits_for_its_client(self) -> bool:
        """Whether nothing is done for it until more comes."""

    def give_way(self) -> None:
        """Close it, so that another one has room."""


Connections = OrderedDict[Connection, str]
"""With the client of each; the one first that was silent longest."""


class OpenConnections:
    """Counts connections, and decides which one gives way."""

    def __init__(self, most: int, most_of_client: int, is_trusted: Callable[[str], bool]) -> None:
        self._most = most
        self._most_of_client = most_of_client
        self._is_trusted = is_trusted
        self._all: Connections = OrderedDict()
        self._of_client: dict[str, Connections] = {}

    def __len__(self) -> int:
        return len(self._all)

    def add(self, connection: Connection, address: str) -> bool:
        """Whether there is room for a new connection. Where there is none it counts all the same, until it is refused."""
        client = network_of(address)
        own = self._of_client.setdefault(client, OrderedDict())
        has_room = self._is_trusted(address) or self._make_room(own, self._most_of_client)
        has_room = has_room and self._make_room(self._all, self._most)
        self._all[connection] = client
        self._of_client.setdefault(client, own)[connection] = client
        return has_room

    def heard_from(self, connection: Connection) -> None:
        """Note that something came on it."""
        if connection in self._all:
            self._all.move_to_end(connection)
            self._of_client[self._all[connection]].move_to_end(connection)

    def remove(self, connection: Connection) -> None:
        """Forget a connection that has ended, or that gives way."""
        client = self._all.pop(connection, None)
        if client is not None:
            own = self._of_client[client]
            del own[connection]
            if not own:
                del self._of_client[client]

    def _make_room(self, connections: Connections, most: int) -> bool:
        while len(connections) >= most:
            oldest = next((each for each in connections if each.waits_for_its_client), None)
            if oldest is None:
                return False
            self.remove(oldest)
            oldest.give_way()
        return True
