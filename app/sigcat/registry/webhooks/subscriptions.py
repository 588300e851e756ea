"""Subscriptions: addresses to which events of some types are sent."""

import json
import secrets
from collections.abc import Sequence
from typing import NamedTuple

from sqlalchemy import Connection, delete, insert, select

from sigcat import codes
from sigcat.findings import shown
from sigcat.names import did_you_mean
from sigcat.registry.events import TYPES
from sigcat.registry.reference import refused, unknown
from sigcat.registry.storing.database import writing
from sigcat.registry.storing.entry import now
from sigcat.registry.storing.ledger import Registry, last_number
from sigcat.registry.storing.tables import DELIVERIES, SUBSCRIPTIONS
from sigcat.registry.webhooks.addresses import Forbidden, Policy, checked_url
from sigcat.registry.webhooks.signing import new_secret

_PREFIX = TYPES[0].rpartition(".")[0]


class Subscription(NamedTuple):
    """An address with the types of events that it gets."""

    id: str
    url: str
    types: tuple[str, ...]
    """Types of events; empty for all."""
    secret: str
    at: str
    number: int
    """Number of the last entry of the log whose event was considered."""


def subscribe(registry: Registry, url: str, types: Sequence[str], policy: Policy) -> Subscription:
    """Send events from now on to an address. Raises InputRefused."""
    try:
        checked_url(url, policy)
    except Forbidden as error:
        message = f"Webhooks cannot be sent to {shown(url)}: {error}."
        raise refused(codes.WEBHOOK_UNFIT.finding(message, fix=error.fix)) from None
    chosen = tuple(dict.fromkeys(map(_type_of, types)))
    with writing(registry.database) as connection:
        number = last_number(connection)
        made = Subscription(f"sub_{secrets.token_hex(8)}", url, chosen, new_secret(), now(), number)
        connection.execute(insert(SUBSCRIPTIONS).values({**made._asdict(), "types": json.dumps(made.types)}))
    return made


def _type_of(name: str) -> str:
    """The type of a name, which may be without its prefix. Raises InputRefused."""
    found = name if "." in name else f"{_PREFIX}.{name}"
    if found not in TYPES:
        known = [each.rpartition(".")[2] for each in TYPES]
        fix = did_you_mean(name, known) or f"Known are {', '.join(known)}."
        raise refused(codes.WEBHOOK_UNFIT.finding(f"Unknown type of events: {shown(name)}.", fix=fix))
    return found


def unsubscribe(registry: Registry, subscription: str) -> None:
    """Remove a subscription with its deliveries. Raises InputRefused."""
    with writing(registry.database) as connection:
        known = [each.id for each in subscriptions(connection)]
        if subscription not in known:
            raise unknown("subscription", subscription, known)
        connection.execute(delete(DELIVERIES).where(DELIVERIES.c.subscription_id == subscription))
        connection.execute(delete(SUBSCRIPTIONS).where(SUBSCRIPTIONS.c.id == subscription))


def subscriptions(connection: Connection) -> tuple[Subscription, ...]:
    """All subscriptions, the oldest first."""
    rows = connection.execute(select(SUBSCRIPTIONS).order_by(SUBSCRIPTIONS.c.at, SUBSCRIPTIONS.c.id)).mappings()
    return tuple(Subscription(**{**row, "types": tuple(json.loads(row["types"]))}) for row in rows)
