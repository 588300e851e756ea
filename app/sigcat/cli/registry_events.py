"""`sigcat registry events`: changes of the registry as lines of JSON."""

import argparse
import time

from sigcat.cli.registry_options import Actions, add_action, read_registry

_PAUSE = 1.0
"""Seconds between two looks at the log."""


def add_events(actions: Actions) -> None:
    """Add the action."""
    parser = add_action(actions, "events", "print the changes of the registry as CloudEvents, one a line", events)
    parser.add_argument("--after", metavar="ID", default="", help="only events after this one")
    parser.add_argument("--follow", action="store_true", help="wait for more events, until interrupted")


def events(arguments: argparse.Namespace) -> int:
    """Print the events in order."""
    from sigcat.registry.events import event_text, events_after, number_of_event

    with read_registry(arguments) as connection:
        number = number_of_event(connection, arguments.after)
    while True:
        with read_registry(arguments) as connection:
            found = events_after(connection, number)
        for event in found:
            print(event_text(event), flush=arguments.follow)
        if found:
            number = int(found[-1]["sequence"])
        elif arguments.follow:
            time.sleep(_PAUSE)
        else:
            return 0
