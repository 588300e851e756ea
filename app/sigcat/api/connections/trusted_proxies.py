"""Addresses of the operator's proxies."""

from collections.abc import Callable, Iterable
from functools import lru_cache
from ipaddress import IPv4Network, IPv6Network, ip_address, ip_network


def trusted_by(proxies: Iterable[str]) -> Callable[[str], bool]:
    """Whether an address is that of a trusted proxy: an address, a network such as `10.0.0.0/8`, or `*` for all."""
    named = frozenset(proxies)
    networks = [network for each in named if (network := _network(each))]

    @lru_cache(256)
    def is_trusted(address: str) -> bool:
        return bool({"*", address} & named) or any(_is_within(address, network) for network in networks)

    return is_trusted


def _network(text: str) -> IPv4Network | IPv6Network | None:
    try:
        return ip_network(text)
    except ValueError:
        return None


def _is_within(address: str, network: IPv4Network | IPv6Network) -> bool:
    try:
        return ip_address(address) in network
    except ValueError:
        return False
