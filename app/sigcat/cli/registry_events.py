"""`sigcat registry events`: changes of the registry as lines of JSON, or of text."""

import argparse
import sys
import time
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from sigcat.cli.ended_by_signals import was_interrupted
from sigcat.cli.registry_options import Actions, add_action, add_server, read_registry, server_of
from sigcat.errors import UsageError
from sigcat.terminal_text import printable

if TYPE_CHECKING:
    from sigcat.registry.access.remote import Server
    from sigcat.registry.events import Event

_PAUSE = 1.0
"""Seconds between two looks at the log, and before the first attempt to reach a service again."""
_LONGEST_PAUSE = 30.0
_WAIT = 30
"""Seconds for which a service is asked to wait for an event: proxies end connections without traffic, often after 60 s."""


def add_events(actions: Actions) -> None:
    """Add the action."""
    parser = add_action(actions, "events", "print the changes of the registry as CloudEvents, one a line", events)
    add_server(parser)
    parser.add_argument("--after", metavar="ID", default="", help="only events after this one")
    parser.add_argument("--follow", action="store_true", help="wait for more events, until interrupted")
    parser.add_argument(
        "--format", choices=("json", "text"), default="json",
        help="json: CloudEvents, one a line; text: time, type and subject (default: %(default)s)",
    )  # fmt: skip


def events(arguments: argparse.Namespace) -> int:
    """Print the events in order. An interrupt is the end of following them."""
    from sigcat.registry.events import event_text

    server = server_of(arguments)
    pages = _of_server(server, arguments) if server else _of_database(arguments)
    try:
        for page in pages:
            for event in page:
                print(event_text(event) if arguments.format == "json" else _line(event), flush=arguments.follow)
            if was_interrupted():  # in a library that swallowed the exception
                raise KeyboardInterrupt
    except (KeyboardInterrupt, Exception):
        if not (arguments.follow and was_interrupted()):
            raise
    return 0


def _line(event: "Event") -> str:
    return printable(f"{event['time']}  {event['type'].rpartition('.')[2]}  {event['subject']}")


def _of_database(arguments: argparse.Namespace) -> "Iterator[Sequence[Event]]":
    from sigcat.registry.events import events_after, number_of_event

    with read_registry(arguments) as connection:
        number = number_of_event(connection, arguments.after)
    while True:
        with read_registry(arguments) as connection:
            found = events_after(connection, number)
        yield found
        if found:
            number = int(found[-1]["sequence"])
        elif arguments.follow:
            time.sleep(_PAUSE)
        else:
            return


def _of_server(server: "Server", arguments: argparse.Namespace) -> "Iterator[Sequence[Event]]":
    number = _number_of_event(server, arguments.after)
    yield from _followed(server, number) if arguments.follow else _pages(server, number)


def _pages(server: "Server", number: int) -> "Iterator[Sequence[Event]]":
    found, number = server.events(number)
    while found:
        yield found
        found, number = server.events(number)


def _number_of_event(server: "Server", event_id: str) -> int:
    """Return the number of the entry of an event; 0 without an id. Raises InputRefused."""
    from sigcat.registry.reference import unknown

    if not event_id:
        return 0
    for event in (event for page in _pages(server, 0) for event in page):
        if event["id"] == event_id:
            return int(event["sequence"])
    raise unknown("event", event_id, ())


def _followed(server: "Server", number: int) -> "Iterator[Sequence[Event]]":
    """Yield events as they come. Once the service has answered, it is asked again when it does not."""
    from sigcat.registry.access.remote import Unanswered

    found, number = server.events(number)
    last: Event | None = None
    pause = 0.0
    while True:
        yield found
        last = found[-1] if found else last
        try:
            if pause and last:
                _check_log(server, last)
            found, number = server.events(number, _WAIT)
            pause = 0.0
        except Unanswered as error:
            if not pause:
                print(f"sigcat: {error}; waiting for it", file=sys.stderr)
            found, pause = (), min(2 * pause or _PAUSE, _LONGEST_PAUSE)
            time.sleep(pause)


def _check_log(server: "Server", last: "Event") -> None:
    """Raise UsageError if the log does not have the last event that was printed: another one took its place."""
    found, _ = server.events(int(last["sequence"]) - 1)
    if not found or found[0]["id"] != last["id"]:
        raise UsageError(f"{server.address} has another log than before. Follow it again, from its first event on.")
