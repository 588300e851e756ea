"""`sigcat registry subscribe`, `deliver` and the other actions of webhooks."""

import argparse
import sys
import time
from typing import TYPE_CHECKING

from sigcat.cli.project_options import project_of
from sigcat.cli.registry_options import Actions, add_action, print_more, read_registry, registry_of
from sigcat.terminal_text import printable

if TYPE_CHECKING:
    from sigcat.registry.webhooks.addresses import Policy
    from sigcat.registry.webhooks.deliveries import Delivery

_PAUSE = 1.0
"""Seconds between two looks at what is due."""
_STATES = ("waiting", "delivered", "failed")


def add_webhooks(actions: Actions) -> None:
    """Add the actions."""
    subscribing = add_action(actions, "subscribe", "send events to a webhook from now on", subscribe)
    subscribing.add_argument("url", metavar="URL", help="address, whose host `webhook-hosts` allows")
    subscribing.add_argument(
        "--types", metavar="TYPE,...", default="", help="types of events, such as published,pending (default: all)"
    )
    ending = add_action(actions, "unsubscribe", "remove a subscription and its deliveries", unsubscribe)
    ending.add_argument("id", metavar="ID", help="subscription")
    add_action(actions, "subscriptions", "list subscriptions", list_subscriptions)
    delivering = add_action(actions, "deliver", "send events to webhooks, until interrupted", deliver)
    delivering.add_argument("--once", action="store_true", help="send what is due, and end")
    listing = add_action(actions, "deliveries", "list deliveries with their last answers", list_deliveries)
    listing.add_argument("--state", choices=_STATES, help="only these")
    again = add_action(actions, "redeliver", "send a delivery again with the same id", redeliver)
    again.add_argument("id", metavar="ID", help="delivery")


def _policy(arguments: argparse.Namespace) -> "Policy":
    from ipaddress import ip_network

    from sigcat.registry.webhooks.addresses import Policy

    settings = project_of(arguments).registry
    assert settings is not None
    return Policy(settings.webhook_hosts, tuple(map(ip_network, settings.webhook_networks)))


def subscribe(arguments: argparse.Namespace) -> int:
    """Print the id and the secret of a new subscription."""
    registry = registry_of(arguments)
    from sigcat.registry.webhooks.subscriptions import subscribe as subscribe_to

    types = [each.strip() for each in arguments.types.split(",") if each.strip()]
    made = subscribe_to(registry, arguments.url, types, _policy(arguments))
    print(f"{made.id}: secret {made.secret}")
    print("The secret is not shown again: give it to the receiver.", file=sys.stderr)
    return 0


def unsubscribe(arguments: argparse.Namespace) -> int:
    """Remove a subscription."""
    registry = registry_of(arguments)
    from sigcat.registry.webhooks.subscriptions import unsubscribe as remove

    remove(registry, arguments.id)
    print(printable(f"{arguments.id}: removed"))
    return 0


def list_subscriptions(arguments: argparse.Namespace) -> int:
    """Print a line for each subscription, without its secret."""
    with read_registry(arguments) as connection:
        from sigcat.registry.webhooks.subscriptions import subscriptions

        listed = subscriptions(connection)
    for each in listed:
        types = ", ".join(kind.rpartition(".")[2] for kind in each.types) or "all events"
        print(printable(f"{each.id}: {each.url}, {types}"))
    if not listed:
        print("No subscriptions.")
    return 0


def deliver(arguments: argparse.Namespace) -> int:
    """Send what is due, and print a line for each attempt."""
    registry = registry_of(arguments)
    from sigcat.registry.webhooks.deliver import deliver_due

    with read_registry(arguments):
        policy = _policy(arguments)
    while True:
        for each in deliver_due(registry, policy):
            print(_line(each), flush=True)
        if arguments.once:
            return 0
        time.sleep(_PAUSE)


def list_deliveries(arguments: argparse.Namespace) -> int:
    """Print a line for each delivery."""
    with read_registry(arguments) as connection:
        from sigcat.registry.webhooks.deliveries import count_deliveries, deliveries

        listed, count = deliveries(connection, arguments.state), count_deliveries(connection, arguments.state)
    print_more(count)
    for each in listed:
        print(_line(each))
    if not listed:
        print("No deliveries.")
    return 0


def _line(delivery: "Delivery") -> str:
    event = delivery.event
    kind = event["type"].rpartition(".")[2]
    attempts = f"{delivery.attempts} {'attempt' if delivery.attempts == 1 else 'attempts'}"
    answer = f", {delivery.answer}" if delivery.answer else ""
    return printable(
        f"{delivery.id} to {delivery.subscription}: {kind} {event['subject']}, {delivery.state} after {attempts}{answer}"
    )


def redeliver(arguments: argparse.Namespace) -> int:
    """Let the next `sigcat registry deliver` send a delivery again."""
    registry = registry_of(arguments)
    import datetime as dt

    from sigcat.registry.storing.database import writing
    from sigcat.registry.webhooks.deliveries import redeliver as send_again

    with read_registry(arguments):
        pass
    with writing(registry.database) as connection:
        send_again(connection, arguments.id, dt.datetime.now(dt.UTC))
    print(printable(f"{arguments.id}: waiting"))
    return 0
