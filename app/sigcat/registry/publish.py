"""Publish versions: all of a command in one transaction, or none."""

import json
from collections.abc import Iterator, Mapping, Sequence
from typing import Literal, NamedTuple

from sqlalchemy import Connection, and_, bindparam, outerjoin, select

from sigcat import codes
from sigcat.catalogue.comparing.changelog import next_version, part_of
from sigcat.catalogue.comparing.changes import CLASSES
from sigcat.digest import digest_of
from sigcat.findings import Finding, shown
from sigcat.registry.candidates.candidate import Candidate
from sigcat.registry.changes import UseChange, function_changes, node_changes
from sigcat.registry.compatibility.affected import Affected, affected_owners
from sigcat.registry.decisions.approvals import Approval, approvals_of, approving
from sigcat.registry.owners import alike_problem
from sigcat.registry.published import COLUMNS, PUBLISHED, Published, all_versions, version_named
from sigcat.registry.reference import CHANGEABLE, DEPLOYABLE, Kind, Reference, Rule, name_problem, refused
from sigcat.registry.storing.content import content_of
from sigcat.registry.storing.ledger import Ledger, Registry, ledger_of
from sigcat.registry.storing.tables import NAMES, VERSIONS
from sigcat.registry.use import from_json
from sigcat.registry.version import RELEASED, is_enough, raised_part, version_of, version_problem

Status = Literal["published", "draft", "pending", "unchanged"]


class Outcome(NamedTuple):
    """The outcome of a candidate."""

    kind: Kind
    reference: Reference
    status: Status
    approvals: tuple[Approval, ...] = ()
    """Decisions that a pending version waits for, and those that owners have made."""
    owner: str = ""
    previous_owner: str = ""
    """Owner of the newest version of the name before; empty if it stays the owner, or there was none."""

    @property
    def sentence(self) -> str:
        """The status, and both owners if the name has another one now."""
        change = f", owner changed from {self.previous_owner} to {self.owner or 'none'}" if self.previous_owner else ""
        return f"{self.kind} {self.reference}: {self.status}{change}"


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
            known = _known(ledger.connection, each)
            problems = list(_problems(ledger, each, known, is_draft=is_draft))
            findings += problems
            if not problems:
                outcomes.append(_publish(ledger, each, known, candidates, is_draft=is_draft))
        if findings:
            raise refused(*findings)
        return Receipt(tuple(outcomes), ledger.head_hash)


class _Known(NamedTuple):
    """Facts about the name of a candidate before it is published."""

    name: str = ""
    """The name as it is published; it may differ in case. Empty for a new one."""
    rule: Rule | None = None
    release: Published | None = None
    """The published version that differs at most in build metadata."""
    newest_owner: str | None = None
    """Owner of the newest other version."""
    newest_precedence: str = ""


def _malformed(candidate: Candidate) -> Iterator[Finding]:
    problem = name_problem(candidate.name, candidate.kind)
    if problem is not None:
        yield problem._replace(file=candidate.file)
    found = version_problem(candidate.version)
    if found is not None:
        yield codes.VERSION_NOT_SEMANTIC.finding(found.message, candidate.file, fix=found.fix)


def _publish(
    ledger: Ledger, candidate: Candidate, before: _Known, together: Sequence[Candidate], *, is_draft: bool
) -> Outcome:
    known = before.release
    content, resolved, uses = ledger.put(candidate.content, candidate.resolved, candidate.uses)
    data = {
        "kind": candidate.kind, "name": candidate.name, "version": candidate.version,
        "owner": candidate.owner, "content": content, "resolved": resolved, "uses": uses,
    }  # fmt: skip
    is_same = known is not None and (known.content, known.uses) == (data["content"], data["uses"])
    if known is not None and is_same and (known.state not in CHANGEABLE or (known.state == "draft" and is_draft)):
        return Outcome(candidate.kind, known.reference, "unchanged", owner=known.owner)
    previous = _previous_owner(candidate, before)
    if previous:
        data["previous_owner"] = previous
    is_asking = before.rule == "approval" and not is_draft
    affected = _asked_owners(ledger.connection, candidate, together) if is_asking else {}
    if affected.keys() <= _approving(ledger.connection, known, data):
        state: Status = "draft" if is_draft else "published"
        ledger.append("publish", {**data, "state": state})
        return Outcome(candidate.kind, candidate.reference, state, (), candidate.owner, previous)
    asked = _ask(ledger, candidate, data, affected, known if is_same else None)
    return asked._replace(owner=candidate.owner, previous_owner=previous)


def _previous_owner(candidate: Candidate, before: _Known) -> str:
    """Owner of the draft that the candidate replaces, else of the newest version of the name if that is older; empty if it stays."""
    if before.release is not None and before.release.owner != candidate.owner:
        return before.release.owner
    is_newer = before.newest_precedence < _key(candidate)["before"]
    return before.newest_owner or "" if is_newer and before.newest_owner != candidate.owner else ""


def _approving(connection: Connection, known: Published | None, data: Mapping[str, str]) -> frozenset[str]:
    return frozenset() if known is None else approving(connection, known.id, data["content"], data["uses"])


def _asked_owners(connection: Connection, candidate: Candidate, together: Sequence[Candidate]) -> Affected:
    """Owners that the rule `approval` asks: a new major version breaks no vehicle that keeps the version before it."""
    base, version = _baseline(connection, candidate), version_of(candidate.version)
    if base is not None and version is not None and raised_part(base.precedence, version) == "major":
        return {}
    return affected_owners(connection, candidate, together, base.owner if base else candidate.owner)


def _ask(
    ledger: Ledger, candidate: Candidate, data: Mapping[str, str], affected: Affected, known: Published | None
) -> Outcome:
    """Store a version as pending, unless the same content asks the same owners already."""
    asked = {owner: ", ".join(functions) for owner, functions in affected.items()}
    before = approvals_of(ledger.connection, known) if known is not None and known.state == "pending" else None
    if before is None or asked != {each.owner: each.functions for each in before}:
        ledger.append("publish", {**data, "state": "pending", "broken": affected})
    stored = version_named(ledger.connection, candidate.kind, candidate.reference)
    return Outcome(candidate.kind, stored.reference, "pending", approvals_of(ledger.connection, stored))


def _problems(ledger: Ledger, candidate: Candidate, before: _Known, *, is_draft: bool) -> Iterator[Finding]:
    connection, known = ledger.connection, before.release
    if before.name not in ("", candidate.name):
        message = f"The name must be {before.name!r}, as it is published, not {candidate.name!r}."
        yield codes.PUBLISHED_NAME_UNFIT.finding(message, candidate.file, fix="Use the same case.")
    if candidate.owner != before.newest_owner and (message := alike_problem(connection, candidate.owner)):
        fix = "Use the same spelling."
        yield codes.PUBLISHED_NAME_UNFIT.finding(message, candidate.file, path=candidate.name, fix=fix)
    if ledger.author.owner:
        owners = [each.owner for each in all_versions(connection, candidate.kind, candidate.name)]
        for problem in ledger.author.refusals(candidate.name, [*owners[-1:], candidate.owner]):
            yield problem._replace(file=candidate.file)
    if known is not None and known.state not in CHANGEABLE:
        yield from _taken(connection, candidate, known)
    elif not is_draft:
        yield from _too_low(connection, candidate)


def _known(connection: Connection, candidate: Candidate) -> _Known:
    key = _key(candidate)
    row = connection.execute(_NAME_AND_RELEASE, key).first()
    if row is None:
        return _Known()
    published = Published._make(row)
    if published.name != candidate.name:
        return _Known(published.name, published.rule)
    newest = connection.execute(_NEWEST_OTHER, {**key, "is_version": candidate.version}).first()
    return _Known(published.name, published.rule, published if row.id is not None else None, *(newest or ()))


def _key(candidate: Candidate) -> Mapping[str, str]:
    version = version_of(candidate.version)
    assert version is not None
    return {
        "of_kind": candidate.kind, "of_name": candidate.name, "of_folded": candidate.name.casefold(),
        "is_release": version.release, "before": version.sort_text,
    }  # fmt: skip


_OF_NAME = PUBLISHED.where(
    NAMES.c.kind == bindparam("of_kind"), NAMES.c.folded == bindparam("of_folded"), NAMES.c.name == bindparam("of_name")
)
_NEWEST_OTHER = (
    select(VERSIONS.c.owner, VERSIONS.c.precedence).join(NAMES)
    .where(NAMES.c.kind == bindparam("of_kind"), NAMES.c.folded == bindparam("of_folded"))
    .where(NAMES.c.name == bindparam("of_name"), VERSIONS.c.version != bindparam("is_version"))
    .order_by(VERSIONS.c.precedence.desc(), VERSIONS.c.id.desc()).limit(1)
)  # fmt: skip
_OF_RELEASE = and_(VERSIONS.c.name_id == NAMES.c.id, VERSIONS.c.release == bindparam("is_release"))
_NAME_AND_RELEASE = (
    select(*COLUMNS)
    .select_from(outerjoin(NAMES, VERSIONS, _OF_RELEASE))
    .where(NAMES.c.kind == bindparam("of_kind"), NAMES.c.folded == bindparam("of_folded"))
)
_RELEASES_BEFORE = (
    _OF_NAME.where(VERSIONS.c.state.in_(sorted(DEPLOYABLE)), VERSIONS.c.precedence < bindparam("before"))
    .where(VERSIONS.c.precedence.endswith(RELEASED)).order_by(VERSIONS.c.precedence.desc()).limit(1)
)  # fmt: skip


def _taken(connection: Connection, candidate: Candidate, known: Published) -> Iterator[Finding]:
    if content_of(connection, known.content) != candidate.content:
        message = f"{known.reference} is published with other bytes."
    elif content_of(connection, known.uses) != candidate.uses:
        message = f"{known.reference} is published over a catalogue in which its signals differ."
    elif candidate.owner not in ("", known.owner):
        message = f"{known.reference} is published with {_owner(known.owner)}, not with {_owner(candidate.owner)}."
    else:
        return
    fix = "Publish it under a new version."
    yield codes.VERSION_TAKEN.finding(message, candidate.file, path=str(known.reference), fix=fix)


def _owner(name: str) -> str:
    return f"the owner {shown(name)}" if name else "no owner"


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
    row = connection.execute(_RELEASES_BEFORE, _key(candidate)).first()
    return None if row is None else Published._make(row)


def _changes(connection: Connection, base: Published, candidate: Candidate) -> tuple[UseChange, ...]:
    if candidate.kind == "function":
        if base.uses == digest_of(candidate.uses):
            return ()  # most versions change code alone
        old = from_json(content_of(connection, base.uses))
        return tuple(function_changes(old, from_json(candidate.uses)))
    nodes: Mapping[str, Mapping[str, object]] = json.loads(content_of(connection, base.resolved))
    return tuple(node_changes(nodes, candidate.nodes, json.loads(candidate.resolved)))


def _worst(changes: Sequence[UseChange]) -> str:
    worst = min(changes, key=lambda change: CLASSES.index(change.compatibility))
    return f"{worst.sentence} is {worst.compatibility}"
