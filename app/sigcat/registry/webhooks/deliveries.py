"""Deliveries of events to subscriptions: which wait, which process sends one, and what became of it."""

import datetime as dt
from collections.abc import Iterator
from typing import NamedTuple

from sqlalchemy import ColumnElement, Connection, RowMapping, func, insert, select, true, update

from sigcat.digest import digest_of
from sigcat.limits import REGISTRY_ROWS, WEBHOOK_ATTEMPTS
from sigcat.registry.events import Event, event_of, source_of, type_of
from sigcat.registry.reference import unknown
from sigcat.registry.storing.entry import Link, time_text
from sigcat.registry.storing.ledger import log_page
from sigcat.registry.storing.tables import DELIVERIES, LOG, SUBSCRIPTIONS
from sigcat.registry.webhooks.sending import Answer
from sigcat.registry.webhooks.subscriptions import Subscription, subscriptions

LEASE = dt.timedelta(seconds=120)
"""Time for which one process sends a delivery: it is longer than an attempt. After a crash another process sends it."""
_FIRST, _GROWTH, _LONGEST = 5, 4, 6 * 3600
"""Seconds of the first pause, its growth, and seconds of the longest pause."""


class Delivery(NamedTuple):
    """An event for a subscription."""

    id: str
    """Id of the webhook: the same in each attempt."""
    subscription: str
    url: str
    secret: str
    event: Event
    state: str
    """`waiting`, `delivered` or `failed`."""
    attempts: int
    due: str
    lease: str
    """Time until which a process sends it."""
    answer: str
    """The last answer."""


def plan(connection: Connection, at: str) -> None:
    """Add a delivery of each new event to each subscription that gets it."""
    for each in subscriptions(connection):
        links = log_page(connection, each.number, REGISTRY_ROWS)
        rows = [
            {
                "id": _delivery_id(each, link), "subscription_id": each.id, "number": link.number, "state": "waiting",
                "attempts": 0, "due": at, "lease": "", "at": "", "answer": "",
            }
            for link in links
            if not each.types or type_of(link.entry) in each.types
        ]  # fmt: skip
        if rows:
            connection.execute(insert(DELIVERIES), rows)
        if links:
            planned = update(SUBSCRIPTIONS).where(SUBSCRIPTIONS.c.id == each.id).values(number=links[-1].number)
            connection.execute(planned)


def _delivery_id(subscription: Subscription, link: Link) -> str:
    return f"msg_{digest_of(f'{subscription.id} {link.hash}'.encode())[:32]}"


def claim(connection: Connection, moment: dt.datetime) -> Delivery | None:
    """Take the delivery that is due for the longest time, so that no other process sends it; None if none is due."""
    at = time_text(moment)
    due = (DELIVERIES.c.state == "waiting") & (DELIVERIES.c.due <= at) & (DELIVERIES.c.lease <= at)
    found = next(_deliveries(connection, due, most=1), None)
    if found is None:
        return None
    lease = time_text(moment + LEASE)
    same = (DELIVERIES.c.id == found.id) & (DELIVERIES.c.lease == found.lease)
    is_taken = connection.execute(update(DELIVERIES).where(same).values(lease=lease)).rowcount == 1
    return found._replace(lease=lease) if is_taken else None


def finish(connection: Connection, delivery: Delivery, answer: Answer, moment: dt.datetime) -> Delivery:
    """Record an answer. A failure delays everything else that waits for the same subscription."""
    attempts, at = delivery.attempts + 1, time_text(moment)
    is_last = answer.is_final or attempts >= WEBHOOK_ATTEMPTS
    state = "delivered" if answer.is_delivered else "failed" if is_last else "waiting"
    due = time_text(moment + pause(delivery.id, attempts))
    chosen = update(DELIVERIES).where(DELIVERIES.c.id == delivery.id)
    if state == "waiting":
        mine = DELIVERIES.c.subscription_id == delivery.subscription
        later = update(DELIVERIES).where(mine, DELIVERIES.c.state == "waiting", DELIVERIES.c.due < due)
        connection.execute(later.values(due=due))
    if state != "delivered":
        chosen = chosen.where(DELIVERIES.c.lease == delivery.lease)  # another process sends it, after a long break
    values = {"state": state, "attempts": attempts, "lease": "", "at": at, "answer": answer.text}
    connection.execute(chosen.values(**values))
    return delivery._replace(state=state, attempts=attempts, due=due, answer=answer.text)


def pause(delivery: str, attempts: int) -> dt.timedelta:
    """The time until the next attempt. It differs by up to a quarter between deliveries, and is always the same for one."""
    seconds = min(_LONGEST, _FIRST * _GROWTH ** (attempts - 1))
    share = int(digest_of(f"{delivery} {attempts}".encode())[:8], 16) / 0xFFFFFFFF
    return dt.timedelta(seconds=seconds * (0.75 + share / 2))


def deliveries(connection: Connection, state: str | None = None) -> tuple[Delivery, ...]:
    """Deliveries in the order of events, the newest ones if there are many."""
    return tuple(_deliveries(connection, _in_state(state), most=REGISTRY_ROWS, is_newest=True))[::-1]


def count_deliveries(connection: Connection, state: str | None = None) -> int:
    """Number of deliveries."""
    return int(connection.execute(select(func.count()).select_from(DELIVERIES).where(_in_state(state))).scalar_one())


def _in_state(state: str | None) -> ColumnElement[bool]:
    return DELIVERIES.c.state == state if state else true()


def redeliver(connection: Connection, delivery: str, moment: dt.datetime) -> None:
    """Send a delivery again with the same id. Raises InputRefused."""
    again = {"state": "waiting", "attempts": 0, "due": time_text(moment), "lease": ""}
    chosen = update(DELIVERIES).where(DELIVERIES.c.id == delivery)
    if connection.execute(chosen.values(**again)).rowcount == 0:
        raise unknown("delivery", delivery, connection.execute(select(DELIVERIES.c.id).limit(REGISTRY_ROWS)).scalars())


def _deliveries(
    connection: Connection, condition: ColumnElement[bool], most: int, *, is_newest: bool = False
) -> Iterator[Delivery]:
    """Deliveries of a condition: the newest events first, or those that are due first."""
    order = (DELIVERIES.c.number.desc(), DELIVERIES.c.id) if is_newest else (DELIVERIES.c.due, DELIVERIES.c.number)
    chosen = (
        select(*DELIVERIES.c, *(LOG.c[name].label(f"log_{name}") for name in Link._fields), SUBSCRIPTIONS.c.url,
               SUBSCRIPTIONS.c.secret)
        .join(SUBSCRIPTIONS, SUBSCRIPTIONS.c.id == DELIVERIES.c.subscription_id)
        .join(LOG, LOG.c.number == DELIVERIES.c.number)
        .where(condition)
        .order_by(*order)
        .limit(most)
    )  # fmt: skip
    source = source_of(connection)
    return (_delivery(row, source) for row in connection.execute(chosen).mappings().all())


def _delivery(row: RowMapping, source: str) -> Delivery:
    event = event_of(Link(*(row[f"log_{name}"] for name in Link._fields)), source)
    return Delivery(
        row["id"], row["subscription_id"], row["url"], row["secret"], event, row["state"], row["attempts"], row["due"],
        row["lease"], row["answer"],
    )  # fmt: skip
