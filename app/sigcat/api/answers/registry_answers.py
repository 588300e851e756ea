"""Values of the registry in the schemas of the API. Importing this loads SQLAlchemy."""

from collections.abc import Iterable, Sequence
from typing import Any, Literal, cast

from sigcat.api.answers import registry_schemas as schemas
from sigcat.api.answers.serializers import finding_schema, plain, plain_text
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.errors import NotFound
from sigcat.findings import shown
from sigcat.integration.grouping import grouped
from sigcat.limits import REGISTRY_ROWS
from sigcat.names import nearest
from sigcat.registry.compatibility.conflicts import Conflict
from sigcat.registry.compatibility.deploying import can_deploy
from sigcat.registry.decisions.acknowledgements import Deprecation, deprecations
from sigcat.registry.decisions.approvals import Approval, Decided, Pending, pending
from sigcat.registry.events import event_of, source_of
from sigcat.registry.publish import Receipt
from sigcat.registry.published import Published, Running, all_versions, lines_by_version, names_of, running
from sigcat.registry.reference import DEPLOYABLE, GROUP_OF, KIND_OF, KINDS, Kind, reference_of
from sigcat.registry.storing.content import content_of
from sigcat.registry.storing.database import Snapshot
from sigcat.registry.storing.entry import Link
from sigcat.registry.storing.ledger import head, last_number, link_with, log_page
from sigcat.registry.use import Use, from_json
from sigcat.registry.users import users_in


def registry(connection: Snapshot) -> schemas.Registry:
    """The registry as a whole."""
    last = head(connection)
    counts = {f"{kind}scount": len(names_of(connection, kind)) for kind in KINDS}
    return schemas.Registry(xid="/", epoch=last.number if last else 0, head=log_head(last) if last else None, **counts)


def log_head(link: Link) -> schemas.LogHead:
    """The head of the log."""
    return schemas.LogHead(
        epoch=link.number, createdat=link.entry.at, hash=link.hash, signature=link.signature or None
    )  # fmt: skip


def log_entries(connection: Snapshot, after: int, most: int) -> list[schemas.LogEntry]:
    """Entries of the log from behind a number on."""
    return [
        schemas.LogEntry(
            epoch=each.number, entry=each.text, previous=each.previous, hash=each.hash, signature=each.signature or None
        )
        for each in log_page(connection, after, most)
    ]


def events(connection: Snapshot, after: int, most: int) -> schemas.RegistryEventList:
    """Events of the entries behind a number. A number beyond the log is that of another log: `epoch` is the last one here."""
    links, source = log_page(connection, after, most), source_of(connection)
    found = [schemas.RegistryEvent.model_validate(event_of(each, source)) for each in links]
    epoch = links[-1].number if links else min(after, last_number(connection))
    return schemas.RegistryEventList(registry_events=found, epoch=epoch)


def names(
    connection: Snapshot, group: schemas.RegistryGroup, *, has_versions: bool = False
) -> list[schemas.RegistryName]:
    """All names of a group, in the order in which they were published: a page stays the same while others publish."""
    by_name = grouped(all_versions(connection, KIND_OF[group]), lambda each: each.name)
    in_order = sorted(by_name.values(), key=lambda versions: min(each.id for each in versions))
    lines = lines_by_version(connection) if has_versions else {}
    return [
        _name(
            versions, [_version(each, versions, lines.get(each.id, ())) for each in versions] if has_versions else None
        )
        for versions in in_order
    ]


def _name(versions: Sequence[Published], listed: list[schemas.RegistryVersion] | None = None) -> schemas.RegistryName:
    default = _default(versions)
    return schemas.RegistryName(
        xid=f"/{GROUP_OF[default.kind]}/{default.name}",
        group=GROUP_OF[default.kind],
        name=default.name,
        owner=default.owner or None,
        compatibility_rule=default.rule,
        defaultversionid=default.version,
        versionscount=len(versions),
        createdat=min(each.at for each in versions),
        versions=listed,
    )


def _default(versions: Sequence[Published]) -> Published:
    """The newest release that may be deployed; without one, the newest version."""
    releases = [each for each in versions if each.state in DEPLOYABLE and not each.precedence.prerelease]
    return (releases or versions)[-1]


def name(connection: Snapshot, group: schemas.RegistryGroup, named: str) -> schemas.RegistryName:
    """A published name. Raises NotFound."""
    return _name(_versions(connection, group, named))


def versions(connection: Snapshot, group: schemas.RegistryGroup, named: str) -> schemas.RegistryVersionList:
    """Versions of a name by precedence. Raises NotFound."""
    found = _versions(connection, group, named)
    lines = lines_by_version(connection)
    return schemas.RegistryVersionList(versions=[_version(each, found, lines.get(each.id, ())) for each in found])


def version(
    connection: Snapshot, group: schemas.RegistryGroup, named: str, version_id: str, *, has_uses: bool
) -> schemas.RegistryVersion:
    """A version of a name, on demand with its uses. Raises NotFound."""
    found = _versions(connection, group, named)
    published = _version_in(found, version_id)
    uses = uses_of(connection, published) if has_uses else None
    return _version(published, found, lines_by_version(connection).get(published.id, ()), uses)


def published_at(connection: Snapshot, group: schemas.RegistryGroup, named: str, version_id: str = "") -> Published:
    """A version; without its id the default one. Raises NotFound."""
    found = _versions(connection, group, named)
    return _version_in(found, version_id) if version_id else _default(found)


def _versions(connection: Snapshot, group: schemas.RegistryGroup, named: str) -> tuple[Published, ...]:
    kind = KIND_OF[group]
    found = all_versions(connection, kind, named)
    if not found:
        raise NotFound(f"The registry has no {kind} {shown(named)}.", nearest(named, names_of(connection, kind)))
    return found


def _version_in(versions: Sequence[Published], version_id: str) -> Published:
    found = next((each for each in versions if each.version == version_id), None)
    if found is None:
        known = [each.version for each in versions]
        raise NotFound(f"{versions[0].name} has no version {shown(version_id)}.", nearest(version_id, known))
    return found


def _version(
    published: Published,
    versions: Sequence[Published],
    lines: Iterable[str],
    uses: list[schemas.RegistryUse] | None = None,
) -> schemas.RegistryVersion:
    before = [each.version for each in versions if each.precedence < published.precedence]
    return schemas.RegistryVersion(
        **_identity(published.kind, *published.reference, published.owner),
        isdefault=published == _default(versions),
        ancestorid=before[-1] if before else published.version,
        lifecycle=published.state,
        removal=published.until or None,
        alternative=published.successor or None,
        createdat=published.at,
        content_digest=published.content,
        resolved_digest=published.resolved,
        vehicle_lines=list(lines),
        uses=uses,
    )


def uses_of(connection: Snapshot, published: Published) -> list[schemas.RegistryUse]:
    """Uses of a version; only functions have some."""
    return [_use(each) for each in from_json(content_of(connection, published.uses) or b"[]")]


def _use(use: Use) -> schemas.RegistryUse:
    fields: dict[str, Any] = plain({key: value if value != "" else None for key, value in use._asdict().items()})
    return schemas.RegistryUse(**{**fields, "name": use.name, "values": plain(use.values), "element": use.element})


def users(connection: Snapshot, path: str, over: Catalogue, *, is_complete: bool) -> schemas.RegistryUserList:
    """Users of an element, or of the instances of a definition. Raises InputRefused if the path is unknown."""
    found = users_in(connection, path, over, is_complete=is_complete)
    users = [
        schemas.RegistryUser(
            **_reference(each.published),
            vehicle_lines=list(each.lines),
            through=list(each.through),
            use=_use(each.use),
        )
        for each in found.users
    ]
    return schemas.RegistryUserList(users=users, more=found.more)


def lines(connection: Snapshot, only: str | None) -> schemas.VehicleLineList:
    """All vehicle lines, also those that no longer run anything, or only one. Raises NotFound."""
    known = names_of(connection, "line")
    if only is not None and only not in known:
        raise NotFound(f"The registry has no vehicle line {shown(only)}.", nearest(only, known))
    by_line: dict[str, list[Running]] = {each: [] for each in (known if only is None else [only])}
    for each in running(connection, only):
        by_line[each.line].append(each)
    return schemas.VehicleLineList(lines=[_line(named, found) for named, found in by_line.items()])


def _line(named: str, found: Iterable[Running]) -> schemas.VehicleLine:
    deployments = [schemas.Deployment(**_reference(each.published), since=each.since) for each in found]
    return schemas.VehicleLine(name=named, deployments=deployments)


def _identity(kind: Kind, name: str, version: str, owner: str) -> dict[str, Any]:
    """The fields by which an answer names a version of any kind."""
    group = GROUP_OF[kind]
    return {
        "xid": f"/{group}/{name}/versions/{version}",
        "group": group,
        "name": name,
        "versionid": version,
        "owner": owner or None,
    }


def _reference(published: Published) -> dict[str, Any]:
    """The fields by which an answer names a version of a function."""
    return {
        "name": published.name, "versionid": published.version, "lifecycle": published.state,
        "owner": published.owner or None,
    }  # fmt: skip


def receipt(connection: Snapshot, published: Receipt) -> schemas.RegistryReceipt:
    """The outcome of each posted file."""
    outcomes = [
        schemas.RegistryOutcome(
            **_identity(each.kind, *each.reference, each.owner),
            is_new=each.status != "unchanged",
            is_draft=each.status == "draft",
            is_pending=each.status == "pending",
            previous_owner=each.previous_owner or None,
            approvals=[_approval(approval) for approval in each.approvals],
        )
        for each in published.outcomes
    ]
    return schemas.RegistryReceipt(versions_posted=outcomes, head=head_with(connection, published.head))


def pending_versions(connection: Snapshot) -> schemas.RegistryPendingList:
    """Versions that wait for approvals."""
    return schemas.RegistryPendingList(versions_pending=[_pending(each) for each in pending(connection)])


def _pending(found: Pending) -> schemas.RegistryPending:
    published = found.published
    return schemas.RegistryPending(
        **_identity(published.kind, *published.reference, published.owner),
        content_digest=published.content,
        approvals=[_approval(each) for each in found.approvals],
    )


def deprecated_versions(connection: Snapshot) -> schemas.RegistryDeprecationList:
    """Deprecated versions, and the owners that use them."""
    return schemas.RegistryDeprecationList(
        versions_deprecated=[_deprecation(each) for each in deprecations(connection)]
    )


def _deprecation(found: Deprecation) -> schemas.RegistryDeprecation:
    published = found.published
    return schemas.RegistryDeprecation(
        **_identity(published.kind, *published.reference, published.owner),
        removal=published.until or None,
        alternative=published.successor or None,
        acknowledgements=[
            schemas.RegistryAcknowledgement(
                owner=each.owner, using_functions=each.functions, acknowledged=each.at or None
            )
            for each in found.acknowledgements
        ],
    )


def decision(connection: Snapshot, decided: Decided) -> schemas.RegistryDecision:
    """The answer to a decision."""
    approvals = [_approval(each) for each in decided.approvals]
    return schemas.RegistryDecision(approvals=approvals, head=head_with(connection, decided.head))


def _approval(approval: Approval) -> schemas.RegistryApproval:
    return schemas.RegistryApproval(
        owner=approval.owner,
        broken_functions=approval.functions,
        approval_decision=cast("Literal['approved', 'rejected'] | None", approval.decision or None),
        decided=approval.at or None,
        valid_until=approval.until or None,
        reason=approval.reason or None,
    )


def head_with(connection: Snapshot, digest: str) -> schemas.LogHead | None:
    """The entry of the log with a hash."""
    link = link_with(connection, digest)
    return log_head(link) if link else None


def deployment_answer(connection: Snapshot, references: Sequence[str], line: str) -> schemas.DeploymentAnswer:
    """Whether versions may be deployed to a line. Raises InputRefused."""
    found = can_deploy(connection, [reference_of(text) for text in references], line)
    return schemas.DeploymentAnswer(
        decision=found.decision,
        vehicle_line=found.line,
        deployed=[schemas.VersionReference(name=each.name, versionid=each.version) for each in found.deployed],
        checked=[schemas.VersionReference(name=each.name, versionid=each.version) for each in found.checked],
        conflicts=[_conflict(each) for each in found.conflicts[:REGISTRY_ROWS]],
        finding=finding_schema(found.finding) if found.finding else None,
    )


def _conflict(conflict: Conflict) -> schemas.RegistryConflict:
    return schemas.RegistryConflict(
        rule=conflict.rule,
        severity=conflict.severity,
        message=plain_text(conflict.message),
        path=conflict.path or None,
        attribute=conflict.attribute or None,
        fix=conflict.fix or None,
        sides=[
            schemas.ConflictSide(
                name=side.function, versionid=side.version, owner=side.owner or None, calls=list(side.calls)
            )
            for side in conflict.sides
        ],
        vehicle_lines=list(conflict.lines),
    )
