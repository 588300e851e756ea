"""Pending versions, and the decisions of the owners whose functions they break."""

import datetime as dt
from collections.abc import Mapping, Sequence
from typing import NamedTuple

from sqlalchemy import Connection, select

from sigcat import codes
from sigcat.errors import InputRefused
from sigcat.findings import shown
from sigcat.names import did_you_mean
from sigcat.registry.published import Published, all_versions, version_named
from sigcat.registry.reference import Kind, Reference, refused
from sigcat.registry.storing.entry import Action, now, time_text
from sigcat.registry.storing.ledger import Registry, ledger_of
from sigcat.registry.storing.tables import APPROVALS

VALID_DAYS = 30
"""Days for which an approval is valid, unless its owner chooses others."""
_MOST_DAYS = 3650
_LONGEST_REASON = 1000


class Approval(NamedTuple):
    """The decision of an owner about the content of a pending version."""

    owner: str
    functions: str
    """Functions of the owner that break, with their versions."""
    decision: str
    """`approved`, `rejected`, or empty as long as there is none."""
    at: str
    until: str
    """Time in UTC at which an approval ends."""
    reason: str
    """Reason of a rejection."""

    def is_valid(self, at: str) -> bool:
        """Whether it is an approval that has not ended at a time."""
        return self.decision == "approved" and at < self.until

    def sentence(self, at: str) -> str:
        """The state of the decision."""
        if self.decision == "rejected":
            return f"{self.owner} rejected it: {self.reason}"
        if self.is_valid(at):
            return f"{self.owner} approved it until {self.until[:10]}"
        ended = f", its approval ended on {self.until[:10]}" if self.decision else ""
        return f"{self.owner} must approve it: it breaks {self.functions}{ended}"


class Pending(NamedTuple):
    """A version that is stored, and not published."""

    published: Published
    approvals: tuple[Approval, ...]


class Decided(NamedTuple):
    """The answer to a decision: what all owners say now, and the head of the log."""

    approvals: tuple[Approval, ...]
    head: str


def pending(connection: Connection) -> tuple[Pending, ...]:
    """Pending versions with the decisions about their content."""
    found = (each for each in all_versions(connection) if each.state == "pending")
    return tuple(Pending(each, approvals_of(connection, each)) for each in found)


def approvals_of(connection: Connection, version: Published) -> tuple[Approval, ...]:
    """Decisions of the owners whose functions the content of a version breaks."""
    columns = (APPROVALS.c[name] for name in Approval._fields)
    same = (APPROVALS.c.content == version.content) & (APPROVALS.c.uses == version.uses)
    chosen = select(*columns).where(APPROVALS.c.version_id == version.id, same, APPROVALS.c.functions != "")
    return tuple(map(Approval._make, connection.execute(chosen.order_by(APPROVALS.c.owner))))


def approving(connection: Connection, version_id: int, content: str, uses: str) -> frozenset[str]:
    """Owners with a valid approval of a content."""
    at = now()
    same = (APPROVALS.c.version_id == version_id) & (APPROVALS.c.content == content) & (APPROVALS.c.uses == uses)
    columns = (APPROVALS.c[name] for name in Approval._fields)
    rows = map(Approval._make, connection.execute(select(*columns).where(same)))
    return frozenset(each.owner for each in rows if each.is_valid(at))


def approve(
    registry: Registry, kind: Kind, reference: Reference, owner: str, days: int = VALID_DAYS, content: str = ""
) -> Decided:
    """Approve the content of a pending version for an owner. Raises InputRefused."""
    if not 0 < days <= _MOST_DAYS:
        raise unfit(reference, f"An approval must be valid for 1 to {_MOST_DAYS} days, not {days}.")
    until = time_text(dt.datetime.now(dt.UTC) + dt.timedelta(days=days))
    return _decide(registry, "approve", kind, reference, owner, content, {"until": until})


def reject(registry: Registry, kind: Kind, reference: Reference, owner: str, reason: str, content: str = "") -> Decided:
    """Reject the content of a pending version for an owner. Raises InputRefused."""
    if not reason.strip() or len(reason) > _LONGEST_REASON:
        raise unfit(reference, f"A rejection must have a reason of 1 to {_LONGEST_REASON} characters.")
    return _decide(registry, "reject", kind, reference, owner, content, {"reason": reason.strip()})


def _decide(
    registry: Registry,
    action: Action,
    kind: Kind,
    reference: Reference,
    owner: str,
    content: str,
    decision: Mapping[str, str],
) -> Decided:
    check_author(registry, reference, owner)
    with ledger_of(registry) as ledger:
        version = version_named(ledger.connection, kind, reference)
        _check_pending(version, content)
        _check_owner(reference, owner, approvals_of(ledger.connection, version))
        data = {"kind": kind, "name": reference.name, "version": reference.version, "owner": owner}
        ledger.append(action, {**data, "content": version.content, "uses": version.uses, **decision})
        return Decided(approvals_of(ledger.connection, version), ledger.head_hash)


def check_author(registry: Registry, reference: Reference, owner: str) -> None:
    """A token with an owner decides for this owner alone."""
    own = registry.author.owner
    if own and owner != own:
        message = f"The owner must be {shown(own)}, as that of the token, not {shown(owner)}."
        raise refused(codes.OWNED_BY_ANOTHER.finding(message, path=reference.name, fix="Use a token of the owner."))


def _check_pending(version: Published, content: str) -> None:
    if version.state != "pending":
        message = f"{version.reference} must be pending to be approved or rejected; it is {version.state}."
        raise unfit(version.reference, message)
    if content and content != version.content:
        message = (
            f"The content of {version.reference} must have the SHA-256 {shown(content)}; it has {version.content}."
        )
        raise unfit(version.reference, message, "Read the new content: `sigcat registry show`.")


def _check_owner(reference: Reference, owner: str, approvals: Sequence[Approval]) -> None:
    owners = [each.owner for each in approvals]
    if owner not in owners:
        message = f"The owner must be one whose functions {reference} breaks ({', '.join(owners)}), not {shown(owner)}."
        raise unfit(reference, message, did_you_mean(owner, owners))


def unfit(reference: Reference, message: str, fix: str = "") -> InputRefused:
    """The refusal of a decision about a version."""
    return refused(codes.DECISION_UNFIT.finding(message, path=reference.name, fix=fix))
