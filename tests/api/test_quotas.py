"""`RateLimit-Policy` and `RateLimit` say what one client may have under way (draft-ietf-httpapi-ratelimit-headers-10)."""

import asyncio
import re

import pytest

from sigcat.api.application import create_app
from sigcat.api.settings import Settings
from sigcat.api.work.quotas import Quota, quota_headers
from sigcat.api.work.refusals import BeyondShare
from sigcat.api.work.turns import Turns
from sigcat.catalogue.hosting.library import Library
from tests.api.conftest import Ask, asker
from tests.own_loop import run

OVERLAY = b"Vehicle.Speed:\n  type: sensor\n  datatype: float\n  description: Speed.\n"
ITEM = re.compile(r'"[a-z-]+"(?:;[a-z]+=(?:\d+|"[a-z-]+"))*')


def test_work_names_its_quota_and_that_of_bodies(ask: Ask) -> None:
    answer = ask("/api/v1/lint", "POST", content=OVERLAY)
    policies, limits = (answer.headers[name].split(", ") for name in ("ratelimit-policy", "ratelimit"))
    assert sorted(policies) == ['"bodies";q=6291456;qu="content-bytes"', '"work";q=17;qu="concurrent-requests"']
    assert sorted(limit.partition(";")[0] for limit in limits) == ['"bodies"', '"work"']
    assert all(map(ITEM.fullmatch, (*policies, *limits)))


def test_what_is_not_bounded_names_none(ask: Ask) -> None:
    assert "ratelimit" not in ask("/api/v1/catalogues/small/nodes/Vehicle.Speed").headers


def test_a_client_beyond_its_share_has_nothing_left(library: Library) -> None:
    ask = asker(create_app(library, Settings(bodies_bytes=100)))
    refused = ask("/api/v1/lint", "POST", content=OVERLAY)
    assert refused.status_code == 429
    assert '"bodies";q=25;qu="content-bytes"' in refused.headers["ratelimit-policy"]


def test_what_remains_is_counted_for_each_client() -> None:
    async def remaining() -> list[int]:
        turns = Turns(2, 2, 0.5)
        quotas = [turns.quota_of(client, "work") for client in ("a", "b")]
        found = [quota.remaining() for quota in quotas]
        async with turns.turn("a"):
            found += [quota.remaining() for quota in quotas]
            waiting = asyncio.ensure_future(turns.to_the_end("a", lambda: asyncio.sleep(0)))
            await asyncio.sleep(0)
            found += [quota.remaining() for quota in quotas]
            with pytest.raises(BeyondShare):
                turns.refuse_more("a")
        await waiting
        return [*found, *(quota.remaining() for quota in quotas)]

    assert run(remaining()) == [2, 2, 1, 2, 0, 2, 2, 2]


def test_nothing_left_comes_with_seconds_to_wait() -> None:
    quotas = [Quota("work", "concurrent-requests", 17, lambda: 0), Quota("bodies", "content-bytes", 9, lambda: 5)]
    assert dict(quota_headers(quotas))[b"ratelimit"] == b'"work";r=0;t=2, "bodies";r=5'
