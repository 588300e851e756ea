"""`sigcat registry pending`, `approve` and `reject`: decisions about versions that break functions of other owners."""

import argparse
from typing import TYPE_CHECKING

from sigcat.cli.registry_options import (
    Actions,
    add_action,
    add_server,
    add_version,
    done,
    print_more,
    read_registry,
    registry_of,
    server_of,
)
from sigcat.limits import REGISTRY_ROWS
from sigcat.terminal_text import printable

if TYPE_CHECKING:
    from collections.abc import Iterable, Sequence

    from sigcat.registry.approvals import Approval, Decided, Pending


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
    listed = _waiting_for(_pending(arguments), arguments.owner)
    if not listed:
        print("No version is pending.")
    print_more(len(listed))
    for each in listed[:REGISTRY_ROWS]:
        version = each.published
        print(printable(f"{version.kind} {version.reference}: pending, SHA-256 {version.content}"))
        print_decisions(each.approvals, is_complete=True)
    return 0


def _pending(arguments: argparse.Namespace) -> "Sequence[Pending]":
    """Pending versions of the service or of the database."""
    server = server_of(arguments)
    if server is not None:
        from sigcat.registry import remote

        return remote.pending(server)
    with read_registry(arguments) as connection:
        from sigcat.registry.approvals import pending as pending_versions

        return pending_versions(connection)


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
    from sigcat.registry.reference import reference_of

    reference, server = reference_of(arguments.version), server_of(arguments)
    decision = (arguments.kind, reference, arguments.owner)
    if server is not None:
        from sigcat.registry import remote

        decided, is_signed = remote.approve(server, *decision, arguments.valid_for, arguments.sha256)
    else:
        registry = registry_of(arguments)
        from sigcat.registry.approvals import approve as approve_version

        decided = approve_version(registry, *decision, arguments.valid_for, arguments.sha256)
        is_signed = registry.key is not None
    return _decided(f"{arguments.kind} {reference}: approved by {arguments.owner}", decided, is_signed=is_signed)


def reject(arguments: argparse.Namespace) -> int:
    """Reject a pending version."""
    from sigcat.registry.reference import reference_of

    reference, server = reference_of(arguments.version), server_of(arguments)
    decision = (arguments.kind, reference, arguments.owner)
    if server is not None:
        from sigcat.registry import remote

        decided, is_signed = remote.reject(server, *decision, arguments.reason, arguments.sha256)
    else:
        registry = registry_of(arguments)
        from sigcat.registry.approvals import reject as reject_version

        decided = reject_version(registry, *decision, arguments.reason, arguments.sha256)
        is_signed = registry.key is not None
    return _decided(f"{arguments.kind} {reference}: rejected by {arguments.owner}", decided, is_signed=is_signed)


def _decided(text: str, decided: "Decided", *, is_signed: bool) -> int:
    done(text, decided.head, is_signed=is_signed)
    print_decisions(decided.approvals)
    return 0
