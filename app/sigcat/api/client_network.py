"""Address or network that counts as one client, where each gets a share of something that is bounded."""

from functools import lru_cache
from ipaddress import IPv6Address, IPv6Network, ip_address

_OWN_BITS = 64


@lru_cache(256)
def network_of(address: str) -> str:
    """An IPv4 address as it is; of an IPv6 address its network, since a client usually has all addresses of one."""
    try:
        known = ip_address(address)
    except ValueError:
        return address
    if not isinstance(known, IPv6Address):
        return address
    return str(known.ipv4_mapped or IPv6Network((int(known), _OWN_BITS), strict=False))
