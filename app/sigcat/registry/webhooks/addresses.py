"""Addresses to which webhooks may be sent: allowed hosts, and no private networks unless they are allowed."""

import socket
from collections.abc import Iterator, Sequence
from ipaddress import IPv4Address, IPv4Network, IPv6Address, IPv6Network, ip_address, ip_network
from typing import NamedTuple, TypeAlias
from urllib.parse import SplitResult, urlsplit

Network: TypeAlias = IPv4Network | IPv6Network
_LONGEST = 2000
"""Characters of an address."""
_TRANSLATED = ip_network("64:ff9b::/96"), ip_network("64:ff9b:1::/48"), ip_network("::/96")
"""Networks whose addresses contain others of IPv4."""


class Policy(NamedTuple):
    """Hosts and networks to which webhooks may be sent."""

    hosts: tuple[str, ...] = ()
    networks: tuple[Network, ...] = ()
    """Private networks that hosts may be in."""


class Forbidden(Exception):
    """An address to which nothing may be sent, why, and what allows it."""

    def __init__(self, message: str, fix: str = "Write an address such as https://hooks.example.org/sigcat.") -> None:
        super().__init__(message)
        self.fix = fix


def checked_url(url: str, policy: Policy) -> SplitResult:
    """Return the parts of an address. Raises Forbidden."""
    try:
        parts = urlsplit(url)
        port = parts.port
    except ValueError:
        raise Forbidden("it is not an address of HTTP") from None
    if len(url) > _LONGEST or not url.isascii() or not url.isprintable() or " " in url:
        raise Forbidden(f"it must have at most {_LONGEST} printable characters of ASCII")
    if parts.scheme not in ("https", "http") or not parts.hostname or port == 0:
        raise Forbidden("it must begin with https:// and have a host")
    if parts.scheme == "http" and not policy.networks:
        fix = 'Write https://, or allow the network of the host, such as `webhook-networks = ["10.20.0.0/16"]`.'
        raise Forbidden("http:// is for hosts in `webhook-networks` only", fix)
    if parts.username is not None or parts.password is not None or parts.fragment:
        raise Forbidden("it must have no user, no password and no fragment")
    if parts.hostname not in {host.lower() for host in policy.hosts}:
        fix = f'Allow the host in sigcat.toml: `webhook-hosts = ["{parts.hostname}"]`.'
        raise Forbidden(f"its host {parts.hostname} is not in `webhook-hosts` of [registry]", fix)
    return parts


def resolved(parts: SplitResult, policy: Policy) -> str:
    """Return the numeric address of a host that webhooks may be sent to. Raises Forbidden and OSError.

    The caller connects to this address: another answer of the name service a moment later has no effect.
    """
    assert parts.hostname is not None
    found = list(dict.fromkeys(_addresses(parts.hostname, port_of(parts))))
    allowed = next((each for each in found if is_allowed(each, policy.networks, parts.scheme)), None)
    if allowed is None:
        named = ", ".join(found[:5])
        if parts.scheme == "http":
            raise Forbidden(f"http:// is for `webhook-networks` only, and {parts.hostname} is {named}")
        raise Forbidden(f"{parts.hostname} is {named}, which is in no public network, and not in `webhook-networks`")
    return allowed


def port_of(parts: SplitResult) -> int:
    """The port of an address."""
    return parts.port or (443 if parts.scheme == "https" else 80)


def _addresses(host: str, port: int) -> Iterator[str]:
    for _, _, _, _, address in socket.getaddrinfo(host, port, type=socket.SOCK_STREAM):
        yield str(address[0])


def is_allowed(address: str, networks: Sequence[Network], scheme: str = "https") -> bool:
    """Whether an address is public, or in an allowed network. Text without encryption stays in allowed networks."""
    found = ip_address(address.partition("%")[0])
    if any(found in network for network in networks):
        return True
    return scheme == "https" and _is_public(found)


def _is_public(address: IPv4Address | IPv6Address) -> bool:
    """Whether an address is reached through the Internet. One that contains another address is not trusted."""
    if isinstance(address, IPv6Address):
        embedded = (address.ipv4_mapped, address.sixtofour, address.teredo)
        if any(embedded) or any(address in network for network in _TRANSLATED):
            return False
    return address.is_global and not address.is_multicast and not address.is_reserved
