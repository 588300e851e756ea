"""Deliver everything that is due: at least once, each attempt with the same id."""

import datetime as dt
from collections.abc import Iterator

from sigcat import __version__
from sigcat.registry.events import event_text
from sigcat.registry.storing.database import writing
from sigcat.registry.storing.entry import time_text
from sigcat.registry.storing.ledger import Registry
from sigcat.registry.webhooks.addresses import Policy
from sigcat.registry.webhooks.deliveries import Delivery, claim, finish, plan
from sigcat.registry.webhooks.sending import send
from sigcat.registry.webhooks.signing import signed_headers


def deliver_due(registry: Registry, policy: Policy) -> Iterator[Delivery]:
    """Send what is due, one after the other, and yield each with its answer.

    A transaction is open before and after an attempt, and not meanwhile: others may write.
    """
    while (claimed := _claimed(registry)) is not None:
        body = event_text(claimed.event).encode()
        headers = {
            "Content-Type": "application/cloudevents+json",
            "User-Agent": f"sigcat/{__version__}",
            **signed_headers(claimed.secret, claimed.id, int(_now().timestamp()), body),
        }
        answer = send(claimed.url, body, headers, policy)
        with writing(registry.database) as connection:
            finished = finish(connection, claimed, answer, _now())
        yield finished


def _claimed(registry: Registry) -> Delivery | None:
    moment = _now()
    with writing(registry.database) as connection:
        plan(connection, time_text(moment))
        return claim(connection, moment)


def _now() -> dt.datetime:
    return dt.datetime.now(dt.UTC)
