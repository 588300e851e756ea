"""`sigcat registry deprecations` and `acknowledge`: who uses a deprecated version, and knows of it."""

import argparse

from sigcat.cli.registry_options import Actions, access_of, add_action, add_server, add_version, done, print_more
from sigcat.limits import REGISTRY_ROWS
from sigcat.terminal_text import printable


def add_deprecations(actions: Actions) -> None:
    """Add the actions."""
    text = "list deprecated versions, and the owners that use them"
    listing = add_action(actions, "deprecations", text, deprecations)
    listing.add_argument("--owner", metavar="TEAM", help="only versions that this owner has not acknowledged")
    add_server(listing)
    text = "record that an owner knows of the deprecation of a version"
    acknowledging = add_action(actions, "acknowledge", text, acknowledge)
    add_version(acknowledging)
    add_server(acknowledging)
    acknowledging.add_argument("--owner", required=True, metavar="TEAM", help="owner of functions that use it")


def deprecations(arguments: argparse.Namespace) -> int:
    """Print deprecated versions with the state of each acknowledgement."""
    found = access_of(arguments).deprecations()
    owner = arguments.owner
    listed = [
        each
        for each in found
        if owner is None or any(one.owner == owner and not one.at for one in each.acknowledgements)
    ]
    if not listed:
        print("No version is deprecated.")
    print_more(len(listed))
    for each in listed[:REGISTRY_ROWS]:
        version = each.published
        print(printable(f"{version.kind} {version.reference}: deprecated{version.end}"))
        for one in each.acknowledgements:
            print(f"  {printable(one.sentence)}")
    return 0


def acknowledge(arguments: argparse.Namespace) -> int:
    """Acknowledge a deprecation."""
    from sigcat.registry.reference import reference_of

    reference = reference_of(arguments.version)
    change = access_of(arguments).acknowledge(arguments.kind, reference, arguments.owner)
    return done(f"{arguments.kind} {reference}: acknowledged by {arguments.owner}", change)
