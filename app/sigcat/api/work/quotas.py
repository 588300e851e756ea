"""Quotas of one client, and the headers that name them (draft-ietf-httpapi-ratelimit-headers-10)."""

from collections.abc import Callable, Iterable
from typing import Literal, NamedTuple

from starlette.requests import HTTPConnection

from sigcat.api.work.refusals import RETRY_SECONDS

Headers = list[tuple[bytes, bytes]]


class Quota(NamedTuple):
    """The share of one client in something that is bounded."""

    name: str
    unit: Literal["concurrent-requests", "content-bytes"]
    most: int
    remaining: Callable[[], int]
    """The part of it that the client may still use."""


def mark_quota(request: HTTPConnection, quota: Quota) -> None:
    """Keep a quota that the request uses: the answer names it."""
    request.scope.setdefault("state", {}).setdefault("quotas", {})[quota.name] = quota


def quota_headers(quotas: Iterable[Quota]) -> Headers:
    """`RateLimit-Policy` and `RateLimit` with an item for each quota."""
    policies = ", ".join(f'"{each.name}";q={each.most};qu="{each.unit}"' for each in quotas)
    limits = ", ".join(_limit(each.name, each.remaining()) for each in quotas)
    return [(b"ratelimit-policy", policies.encode()), (b"ratelimit", limits.encode())]


def _limit(name: str, remaining: int) -> str:
    return f'"{name}";r={remaining}' if remaining > 0 else f'"{name}";r=0;t={RETRY_SECONDS}'
