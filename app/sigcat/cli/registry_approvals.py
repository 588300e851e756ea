"""`sigcat registry pending`, `approve` and `reject`: decisions about versions that break functions of other owners."""

import argparse
from typing import TYPE_CHECKING

from sigcat.cli.registry_options import Actions, add_action, add_version, done, print_more, read_registry, registry_of
from sigcat.limits import REGISTRY_ROWS
from sigcat.terminal_text import printable

if TYPE_CHECKING:
    from collections.abc import Iterable

    from sigcat.registry.approvals import Approval, Decided
    from sigcat.registry.storing.ledger import Registry


def add_approvals(actions: Actions) -> None:
    """Add the actions."""
    listing = add_action(actions, "pending", "list pending versions and the owners that must approve them", pending)
    listing.add_argument("--owner", metavar="TEAM", help="only versions that this owner must approve")
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
    parser.add_argument("--owner", required=True, metavar="TEAM", help="owner of functions that it breaks")
    parser.add_argument("--sha256", default="", metavar="DIGEST", help="content that must be pending")


def pending(arguments: argparse.Namespace) -> int:
    """Print pending versions with the state of each decision."""
    with read_registry(arguments) as connection:
        from sigcat.registry.approvals import pending as pending_versions
        from sigcat.registry.storing.entry import now

        at = now()
        listed = [
            each
            for each in pending_versions(connection)
            if arguments.owner is None
            or any(approval.owner == arguments.owner and not approval.is_valid(at) for approval in each.approvals)
        ]
    if not listed:
        print("No version is pending.")
    print_more(len(listed))
    for each in listed[:REGISTRY_ROWS]:
        version = each.published
        print(printable(f"{version.kind} {version.reference}: pending, SHA-256 {version.content}"))
        print_decisions(each.approvals, is_complete=True)
    return 0


def print_decisions(approvals: "Iterable[Approval]", *, is_complete: bool = False) -> None:
    """Print the decisions that a version waits for, below it. `is_complete`: also those that it has."""
    from sigcat.registry.storing.entry import now

    at = now()
    for each in approvals:
        if is_complete or not each.is_valid(at):
            print(f"  {printable(each.sentence(at))}")


def approve(arguments: argparse.Namespace) -> int:
    """Approve a pending version."""
    registry = registry_of(arguments)
    from sigcat.registry.approvals import approve as approve_version
    from sigcat.registry.reference import reference_of

    reference = reference_of(arguments.version)
    decided = approve_version(
        registry, arguments.kind, reference, arguments.owner, arguments.valid_for, arguments.sha256
    )
    return _decided(registry, f"{arguments.kind} {reference}: approved by {arguments.owner}", decided)


def reject(arguments: argparse.Namespace) -> int:
    """Reject a pending version."""
    registry = registry_of(arguments)
    from sigcat.registry.approvals import reject as reject_version
    from sigcat.registry.reference import reference_of

    reference = reference_of(arguments.version)
    decided = reject_version(registry, arguments.kind, reference, arguments.owner, arguments.reason, arguments.sha256)
    return _decided(registry, f"{arguments.kind} {reference}: rejected by {arguments.owner}", decided)


def _decided(registry: "Registry", text: str, decided: "Decided") -> int:
    done(text, decided.head, is_signed=registry.key is not None)
    print_decisions(decided.approvals)
    return 0
