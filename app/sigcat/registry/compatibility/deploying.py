"""Whether versions may be deployed to a vehicle line, and why not."""

from collections.abc import Sequence
from functools import partial
from typing import Literal, NamedTuple

from sqlalchemy import Connection

from sigcat import codes
from sigcat.findings import Finding
from sigcat.names import did_you_mean
from sigcat.registry.compatibility.concerned import concerned
from sigcat.registry.compatibility.conflicts import Conflict, Side, conflicts
from sigcat.registry.compatibility.member import Member, published_member
from sigcat.registry.published import Published, names_of, running, version_named
from sigcat.registry.reference import DEPLOYABLE, Reference, refused

Decision = Literal["yes", "no", "unknown"]


class Answer(NamedTuple):
    """The answer to a question about a deployment."""

    decision: Decision
    line: str
    deployed: tuple[Reference, ...]
    checked: tuple[Reference, ...]
    """Versions in the vehicles of the line that it was checked with."""
    conflicts: tuple[Conflict, ...]
    finding: Finding | None = None
    """Why nothing is known."""


def can_deploy(
    connection: Connection, references: Sequence[Reference], line: str, known: dict[int, Member] | None = None
) -> Answer:
    """Return whether versions, which ship together, fit everything in the vehicles of a line. Raises InputRefused.

    `known` keeps functions that were read, by the id of their version, for the next question.
    """
    member = partial(_member, connection, {} if known is None else known)
    deployed = [deployable(connection, reference) for reference in dict.fromkeys(references)]
    _check_once(deployed)
    names = {each.name for each in deployed}
    field = [each.published for each in running(connection, line)]
    asked = tuple(each.reference for each in deployed)
    if not field:
        return Answer("unknown", line, asked, (), (), _unknown_line(connection, line))
    members = [member(each) for each in deployed]
    replaced = [member(each) for each in field if each.name in names]
    rest = [each for each in field if each.name not in names]
    others = [member(each) for each in concerned(connection, members, replaced, rest)]
    found = tuple(each._replace(lines=(line,)) for each in conflicts(members, others, replaced))
    ended = tuple(_support_ended(each, line) for each in deployed if each.is_unsupported)
    decision: Decision = "no" if any(each.severity == "error" for each in found) else "yes"
    return Answer(decision, line, asked, tuple(each.reference for each in rest), (*found, *ended))


def _member(connection: Connection, known: dict[int, Member], published: Published) -> Member:
    if published.id not in known:
        known[published.id] = published_member(connection, published)
    return known[published.id]


def deployable(connection: Connection, reference: Reference) -> Published:
    """The version of a function that vehicles may run. Raises InputRefused."""
    published = version_named(connection, "function", reference)
    if published.state not in DEPLOYABLE:
        message = f"{reference} must be published to be deployed; it is {published.state}."
        raise refused(codes.VERSION_NOT_DEPLOYABLE.finding(message, path=reference.name))
    return published


def _support_ended(published: Published, line: str) -> Conflict:
    """The warning about a version whose support has ended. It may be deployed: a vehicle keeps it longer than its team."""
    rule = codes.VERSION_NOT_DEPLOYABLE.graded("warning")
    message = f"The support of {published.reference} ended on {published.until}."
    fix = f"Deploy its successor {published.successor}." if published.successor else "Deploy a supported version."
    sides = (Side(published.name, published.version, published.owner, ()),)
    return Conflict(rule.id, rule.severity, message, "", "", sides, fix, lines=(line,))


def _check_once(deployed: Sequence[Published]) -> None:
    names = [each.name for each in deployed]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        message = f"{twice} must be deployed in one version."
        raise refused(codes.VERSION_NOT_DEPLOYABLE.finding(message, path=twice, fix="Remove the other versions."))


def _unknown_line(connection: Connection, line: str) -> Finding:
    message = f"Nothing is deployed in line {line[:100]!r}, so that the answer is unknown."
    near = did_you_mean(line, [name for name in names_of(connection, "line") if name != line])
    fix = near or "Record what its vehicles run: `sigcat registry record-deployment LINE FUNC@V`."
    return codes.LINE_UNKNOWN.finding(message, path=line, fix=fix)
