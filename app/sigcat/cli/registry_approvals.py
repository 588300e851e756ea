"""`sigcat registry pending`, `approve` and `reject`: decisions about versions that break functions of other owners."""

import argparse
from typing import TYPE_CHECKING

from sigcat.cli.registry_options import (
    Actions,
    access_of,
    add_action,
    add_server,
    add_version,
    done,
    print_more,
)
from sigcat.limits import REGISTRY_ROWS
from sigcat.terminal_text import printable

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from sigcat.registry.access.access import Change
    from sigcat.registry.decisions.approvals import Approval, Decided, Pending
    from sigcat.registry.reference import Kind, Reference


def add_approvals(actions: Actions) -> None:
    """Add the actions."""
    listing = add_action(actions, "pending", "list pending versions and the owners that must approve them", pending)
    listing.add_argument("--owner", metavar="TEAM", help="only versions that this owner must approve")
    add_server(listing)
    approving = add_action(actions, "approve", "approve a pending version that breaks functions of an owner", approve)
    _add_decision(approving)
    approving.add_argument(
        "--valid-for", type=int, default=30, metavar="DAYS", help="days until the approval ends (default: %(default)s)"
    )
    rejecting = add_action(actions, "reject", "reject a pending version that breaks functions of an owner", reject)
    _add_decision(rejecting)
    rejecting.add_argument("--reason", required=True, metavar="TEXT", help="reason, which the next publish prints")


def _add_decision(parser: argparse.ArgumentParser) -> None:
    add_version(parser)
    add_server(parser)
    parser.add_argument("--owner", required=True, metavar="TEAM", help="owner of functions that it breaks")
    parser.add_argument("--sha256", default="", metavar="DIGEST", help="content that must be pending")


def pending(arguments: argparse.Namespace) -> int:
    """Print pending versions with the state of each decision."""
    listed = _waiting_for(access_of(arguments).pending(), arguments.owner)
    if not listed:
        print("No version is pending.")
    print_more(len(listed))
    for each in listed[:REGISTRY_ROWS]:
        version = each.published
        print(printable(f"{version.kind} {version.reference}: pending, SHA-256 {version.content}"))
        print_decisions(each.approvals, is_complete=True)
    return 0


def _waiting_for(found: "Sequence[Pending]", owner: str | None) -> "Sequence[Pending]":
    """Those that an owner must approve; without one, all."""
    from sigcat.registry.storing.entry import now

    at = now()
    return [
        each
        for each in found
        if owner is None or any(one.owner == owner and not one.is_valid(at) for one in each.approvals)
    ]


def print_decisions(approvals: "Iterable[Approval]", *, is_complete: bool = False) -> None:
    """Print the decisions that a version waits for, below it. `is_complete`: also those that it has."""
    from sigcat.registry.storing.entry import now

    at = now()
    for each in approvals:
        if is_complete or not each.is_valid(at):
            print(f"  {printable(each.sentence(at))}")


def approve(arguments: argparse.Namespace) -> int:
    """Approve a pending version."""
    access = access_of(arguments)
    return _decided(arguments, "approved", access.approve(*_about(arguments), arguments.valid_for, arguments.sha256))


def reject(arguments: argparse.Namespace) -> int:
    """Reject a pending version."""
    access = access_of(arguments)
    return _decided(arguments, "rejected", access.reject(*_about(arguments), arguments.reason, arguments.sha256))


def _about(arguments: argparse.Namespace) -> "tuple[Kind, Reference, str]":
    """Kind and version, and the owner that decides."""
    from sigcat.registry.reference import reference_of

    return arguments.kind, reference_of(arguments.version), arguments.owner


def _decided(arguments: argparse.Namespace, decision: str, made: "tuple[Decided, Change]") -> int:
    kind, reference, owner = _about(arguments)
    decided, change = made
    done(f"{kind} {reference}: {decision} by {owner}", change)
    print_decisions(decided.approvals)
    return 0
