"""Connections to public addresses only: names are resolved once, and what was checked is what is connected to.

A name may resolve to another address the next time: checking one answer and connecting to the next would check nothing.
"""

import ipaddress
import socket
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

_NAT64 = ipaddress.ip_network("64:ff9b::/96")
"""Prefix of networks without IPv4 for IPv4 addresses, the last 32 bits (RFC 6052)."""


class Place(NamedTuple):
    """An address that a name resolves to."""

    family: int
    address: tuple[Any, ...]
    """As `socket.connect` takes it: the address in numbers first."""


class AddressRefused(Exception):
    """A host has no address that may be asked; the text is one that it has."""


class Network(NamedTuple):
    """Resolution of names to addresses, and of addresses to connections."""

    resolve: Callable[[str, int], Sequence[Place]]
    connect: Callable[[Place, float | None], socket.socket]

    def connected(self, host: str, port: int, seconds: float | None, *, allows_private: bool) -> socket.socket:
        """A connection to the first address that may be asked and answers. Raises AddressRefused or OSError."""
        places = self.resolve(host, port)
        allowed = [place for place in places if allows_private or is_public(place.address[0])]
        if not allowed:
            raise AddressRefused(str(places[0].address[0]) if places else host)
        return self._first_connected(allowed, seconds)

    def _first_connected(self, places: Sequence[Place], seconds: float | None) -> socket.socket:
        for place in places[:-1]:
            try:
                return self.connect(place, seconds)
            except OSError:
                continue
        return self.connect(places[-1], seconds)


def is_public(address: str) -> bool:
    """Whether an address is one of the internet: not of this machine, its network, or a group, however it is written."""
    known = ipaddress.ip_address(address.partition("%")[0])
    if isinstance(known, ipaddress.IPv6Address):
        if known in _NAT64:
            return is_public(str(ipaddress.IPv4Address(int(known) & 0xFFFF_FFFF)))
        if known.ipv4_mapped or known.sixtofour or known.teredo or known.is_site_local:
            return False
    return known.is_global and not known.is_multicast


def numeric_address(host: str) -> str | None:
    """The address, if a host is written in numbers, such as 127.1 or 2130706433; it is not resolved."""
    try:
        found = socket.getaddrinfo(host, None, type=socket.SOCK_STREAM, flags=socket.AI_NUMERICHOST)
    except OSError:
        return None
    return str(found[0][4][0])


def _resolve(host: str, port: int) -> Sequence[Place]:
    found = socket.getaddrinfo(host, port, type=socket.SOCK_STREAM)
    return [Place(family, address) for family, _, _, _, address in found]


def _connect(place: Place, seconds: float | None) -> socket.socket:
    connection = socket.socket(place.family, socket.SOCK_STREAM)
    try:
        connection.settimeout(seconds)
        connection.connect(place.address)
    except BaseException:
        connection.close()
        raise
    return connection


INTERNET = Network(_resolve, _connect)
