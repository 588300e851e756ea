"""Publish versions: all of a command in one transaction, or none."""

import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Literal, NamedTuple

from sqlalchemy import Connection, select

from sigcat import codes
from sigcat.catalogue.comparing.changelog import next_version, part_of
from sigcat.catalogue.comparing.changes import CLASSES
from sigcat.findings import Finding
from sigcat.registry.affected import Affected, affected_owners
from sigcat.registry.approvals import Approval, approvals_of, approving
from sigcat.registry.candidate import Candidate
from sigcat.registry.changes import UseChange, function_changes, node_changes
from sigcat.registry.published import Published, all_versions, version_named
from sigcat.registry.reference import CHANGEABLE, DEPLOYABLE, Kind, Reference, Rule, name_problem, refused
from sigcat.registry.storing.content import content_of
from sigcat.registry.storing.ledger import Ledger, Registry, head, ledger_of
from sigcat.registry.storing.tables import NAMES
from sigcat.registry.use import from_json
from sigcat.registry.version import is_enough, raised_part, version_of

Status = Literal["published", "draft", "pending", "unchanged"]


class Outcome(NamedTuple):
    """What became of a candidate."""

    kind: Kind
    reference: Reference
    status: Status
    approvals: tuple[Approval, ...] = ()
    """Decisions that a pending version waits for, and those that owners have made."""


class Receipt(NamedTuple):
    """The answer to a publish: its outcomes, and the head of the log."""

    outcomes: tuple[Outcome, ...]
    head: str


def publish(registry: Registry, candidates: Sequence[Candidate], *, is_draft: bool = False) -> Receipt:
    """Publish candidates. Raises InputRefused with every reason; then nothing is published."""
    findings = [finding for each in candidates for finding in _malformed(each)]
    if findings:
        raise refused(*findings)
    outcomes: list[Outcome] = []
    with ledger_of(registry) as ledger:
        for each in candidates:
            problems = list(_problems(ledger.connection, each, is_draft=is_draft))
            findings += problems
            if not problems:
                outcomes.append(_publish(ledger, each, candidates, is_draft=is_draft))
        if findings:
            raise refused(*findings)
        last = head(ledger.connection)
    return Receipt(tuple(outcomes), last.hash if last else "")


def _malformed(candidate: Candidate) -> Iterator[Finding]:
    problem = name_problem(candidate.name)
    if problem is not None:
        yield problem._replace(file=candidate.file)
    if version_of(candidate.version) is None:
        message = f"The version must be one of SemVer 2.0, not {candidate.version[:60]!r}."
        fix = "Write three numbers, such as 1.2.0."
        yield codes.VERSION_NOT_SEMANTIC.finding(message, candidate.file, fix=fix)


def _publish(ledger: Ledger, candidate: Candidate, together: Sequence[Candidate], *, is_draft: bool) -> Outcome:
    known = _same_release(ledger.connection, candidate)
    data = {
        "kind": candidate.kind, "name": candidate.name, "version": candidate.version,
        "owner": candidate.owner, "content": ledger.put(candidate.content), "resolved": ledger.put(candidate.resolved),
        "uses": ledger.put(candidate.uses),
    }  # fmt: skip
    is_same = known is not None and (known.content, known.uses) == (data["content"], data["uses"])
    if known is not None and is_same and (known.state not in CHANGEABLE or (known.state == "draft" and is_draft)):
        return Outcome(candidate.kind, known.reference, "unchanged")
    affected = {} if is_draft else _asked_owners(ledger.connection, candidate, together)
    if affected.keys() <= _approving(ledger.connection, known, data):
        state: Status = "draft" if is_draft else "published"
        ledger.append("publish", {**data, "state": state})
        return Outcome(candidate.kind, candidate.reference, state)
    return _ask(ledger, candidate, data, affected, known if is_same else None)


def _approving(connection: Connection, known: Published | None, data: Mapping[str, str]) -> frozenset[str]:
    return frozenset() if known is None else approving(connection, known.id, data["content"], data["uses"])


def _asked_owners(connection: Connection, candidate: Candidate, together: Sequence[Candidate]) -> Affected:
    """Owners that the rule `approval` asks: a new major version breaks nobody that keeps the one before it."""
    if _rule(connection, candidate) != "approval":
        return {}
    base, version = _baseline(connection, candidate), version_of(candidate.version)
    if base is not None and version is not None and raised_part(base.precedence, version) == "major":
        return {}
    return affected_owners(connection, candidate, together, base.owner if base else candidate.owner)


def _rule(connection: Connection, candidate: Candidate) -> Rule | None:
    named = (NAMES.c.kind == candidate.kind) & (NAMES.c.name == candidate.name)
    rule: Rule | None = connection.execute(select(NAMES.c.rule).where(named)).scalar()
    return rule


def _ask(
    ledger: Ledger, candidate: Candidate, data: Mapping[str, str], affected: Affected, known: Published | None
) -> Outcome:
    """Store a version as pending, unless the same content asks the same owners already."""
    asked = {owner: ", ".join(functions) for owner, functions in affected.items()}
    is_asked = known is not None and known.state == "pending" and asked == _asked(ledger.connection, known)
    if not is_asked:
        ledger.append("publish", {**data, "state": "pending", "broken": affected})
    stored = version_named(ledger.connection, candidate.kind, candidate.reference)
    return Outcome(candidate.kind, stored.reference, "pending", approvals_of(ledger.connection, stored))


def _asked(connection: Connection, version: Published) -> Mapping[str, str]:
    return {each.owner: each.functions for each in approvals_of(connection, version)}


def _problems(connection: Connection, candidate: Candidate, *, is_draft: bool) -> Iterator[Finding]:
    yield from _other_spelling(connection, candidate)
    known = _same_release(connection, candidate)
    if known is not None and known.state not in CHANGEABLE:
        yield from _taken(connection, candidate, known)
    elif not is_draft:
        yield from _too_low(connection, candidate)


def _other_spelling(connection: Connection, candidate: Candidate) -> Iterator[Finding]:
    same = (NAMES.c.kind == candidate.kind) & (NAMES.c.folded == candidate.name.casefold())
    known = connection.execute(select(NAMES.c.name).where(same)).scalar()
    if known is not None and known != candidate.name:
        message = f"The name must be {known!r}, as it is published, not {candidate.name!r}."
        yield codes.PUBLISHED_NAME_UNFIT.finding(message, candidate.file, fix="Use the same case.")


def _same_release(connection: Connection, candidate: Candidate) -> Published | None:
    """The published version that differs at most in build metadata."""
    wanted = version_of(candidate.version)
    versions = all_versions(connection, candidate.kind, candidate.name)
    return next((each for each in versions if each.precedence == wanted), None)


def _taken(connection: Connection, candidate: Candidate, known: Published) -> Iterator[Finding]:
    if content_of(connection, known.content) != candidate.content:
        message = f"{known.reference} is published with other bytes."
    elif content_of(connection, known.uses) != candidate.uses:
        message = f"{known.reference} is published over a catalogue in which its signals differ."
    else:
        return
    fix = "Publish it under a new version."
    yield codes.VERSION_TAKEN.finding(message, candidate.file, path=str(known.reference), fix=fix)


def _too_low(connection: Connection, candidate: Candidate) -> Iterator[Finding]:
    """Report a version that does not rise by the part that the rule of its name asks for."""
    base = _baseline(connection, candidate)
    version = version_of(candidate.version)
    if base is None or base.rule == "none" or version is None:
        return
    changes = _changes(connection, base, candidate)
    classes = [change.compatibility for change in changes]
    if base.rule == "full" and "breaking" in classes:
        message = f"{candidate.name} must stay compatible by its rule `full`. {_worst(changes)}."
        fix = f"Keep what {base.reference} has, or publish another name."
        yield codes.VERSION_TOO_LOW.finding(message, candidate.file, path=candidate.name, fix=fix)
        return
    needed = part_of(classes)
    if base.rule == "approval" and needed == "major":
        return  # the owners of functions that break decide
    if not is_enough(raised_part(base.precedence, version), needed):
        message = f"The {needed} part of the version must rise from {base.version}. {_worst(changes)}."
        least = next_version(base.precedence.release, needed)
        yield codes.VERSION_TOO_LOW.finding(message, candidate.file, path=candidate.name, fix=f"Publish it as {least}.")


def _baseline(connection: Connection, candidate: Candidate) -> Published | None:
    """The newest release before the candidate."""
    version = version_of(candidate.version)
    assert version is not None
    before = [
        each for each in all_versions(connection, candidate.kind, candidate.name)
        if each.state in DEPLOYABLE and not each.precedence.prerelease and each.precedence < version
    ]  # fmt: skip
    return before[-1] if before else None


def _changes(connection: Connection, base: Published, candidate: Candidate) -> tuple[UseChange, ...]:
    if candidate.kind == "function":
        old = from_json(content_of(connection, base.uses))
        return tuple(function_changes(old, from_json(candidate.uses)))
    nodes: Mapping[str, Mapping[str, object]] = json.loads(content_of(connection, base.resolved))
    return tuple(node_changes(nodes, candidate.nodes, json.loads(candidate.resolved)))


def _worst(changes: Sequence[UseChange]) -> str:
    worst = min(changes, key=lambda change: CLASSES.index(change.compatibility))
    return f"{worst.sentence} is {worst.compatibility}"
