"""The registry in a database."""

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import NamedTuple

from sigcat.errors import UsageError
from sigcat.registry import lines
from sigcat.registry.access.access import Change, Listed
from sigcat.registry.compatibility.deploying import Answer, can_deploy
from sigcat.registry.decisions import acknowledgements, approvals
from sigcat.registry.decisions.acknowledgements import Deprecation
from sigcat.registry.decisions.approvals import Decided, Pending
from sigcat.registry.published import all_versions, lines_by_version, version_named
from sigcat.registry.reference import Kind, Reference, Rule, State
from sigcat.registry.storing.content import content_of
from sigcat.registry.storing.database import Snapshot, reading
from sigcat.registry.storing.entry import Action
from sigcat.registry.storing.ledger import Registry, head


@contextmanager
def reading_published(registry: Registry) -> Iterator[Snapshot]:
    """One state of a registry. Raises UsageError if nothing is in it: then no answer would mean anything."""
    with reading(registry.database) as connection:
        if head(connection) is None:
            raise UsageError(
                f"nothing is published in {registry.database}: run `sigcat publish` or `sigcat registry import`"
            )
        yield connection


class Local(NamedTuple):
    """Access to a registry in a database."""

    registry: Registry

    def all_versions(self, kind: Kind | None = None) -> tuple[Listed, ...]:
        """Versions by kind, name and precedence."""
        with reading_published(self.registry) as connection:
            where = lines_by_version(connection)
            return tuple(Listed(each, where.get(each.id, ())) for each in all_versions(connection, kind))

    def content(self, kind: Kind, reference: Reference, *, is_resolved: bool) -> bytes:
        """The published bytes of a version; resolved, its Function JSON or its nodes."""
        with reading_published(self.registry) as connection:
            published = version_named(connection, kind, reference)
            return content_of(connection, published.resolved if is_resolved else published.content)

    def can_deploy(self, references: Sequence[Reference], line: str) -> Answer:
        """Whether versions, which ship together, fit everything in the vehicles of a line."""
        with reading_published(self.registry) as connection:
            return can_deploy(connection, references, line)

    def pending(self) -> tuple[Pending, ...]:
        """Versions that wait for approvals."""
        with reading_published(self.registry) as connection:
            return approvals.pending(connection)

    def deprecations(self) -> tuple[Deprecation, ...]:
        """Deprecated versions, and the owners that use them."""
        with reading_published(self.registry) as connection:
            return acknowledgements.deprecations(connection)

    def acknowledge(self, kind: Kind, reference: Reference, owner: str) -> Change:
        """Record that an owner knows of a deprecation."""
        return self._change(acknowledgements.acknowledge(self.registry, kind, reference, owner))

    def record(self, action: Action, line: str, reference: Reference) -> Change:
        """Record a deployment, a release or the end of support."""
        return self._change(lines.record(self.registry, action, line, reference))

    def set_state(self, kind: Kind, reference: Reference, state: State, until: str = "", successor: str = "") -> Change:
        """Deprecate or retire a version."""
        return self._change(lines.set_state(self.registry, kind, reference, state, until, successor))

    def set_rule(self, kind: Kind, name: str, rule: Rule) -> Change:
        """Set the rule of a name."""
        return self._change(lines.set_rule(self.registry, kind, name, rule))

    def approve(self, kind: Kind, reference: Reference, owner: str, days: int, content: str) -> tuple[Decided, Change]:
        """Approve the content of a pending version, and return all decisions."""
        decided = approvals.approve(self.registry, kind, reference, owner, days, content)
        return decided, self._change(decided.head)

    def reject(self, kind: Kind, reference: Reference, owner: str, reason: str, content: str) -> tuple[Decided, Change]:
        """Reject the content of a pending version, and return all decisions."""
        decided = approvals.reject(self.registry, kind, reference, owner, reason, content)
        return decided, self._change(decided.head)

    def _change(self, digest: str) -> Change:
        return Change(digest, is_signed=self.registry.key is not None)
