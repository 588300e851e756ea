"""The questions and changes that commands ask of a registry, wherever it is: in a database, or behind a service."""

from collections.abc import Sequence
from typing import NamedTuple, Protocol

from sigcat.registry.compatibility.deploying import Answer
from sigcat.registry.decisions.acknowledgements import Deprecation
from sigcat.registry.decisions.approvals import Decided, Pending
from sigcat.registry.published import Published
from sigcat.registry.reference import Kind, Reference, Rule, State
from sigcat.registry.storing.entry import Action


class Change(NamedTuple):
    """The head of the log behind a change."""

    head: str
    is_signed: bool


class Listed(NamedTuple):
    """A version, and the lines whose vehicles run it."""

    published: Published
    lines: tuple[str, ...]


class Access(Protocol):
    """A registry. Questions raise UsageError if nothing is in it: then no answer would mean anything."""

    def all_versions(self, kind: Kind | None = None) -> tuple[Listed, ...]:
        """Versions by kind, name and precedence."""

    def content(self, kind: Kind, reference: Reference, *, is_resolved: bool) -> bytes:
        """The published bytes of a version; resolved, its Function JSON or its nodes."""

    def can_deploy(self, references: Sequence[Reference], line: str) -> Answer:
        """Whether versions, which ship together, fit everything in the vehicles of a line."""

    def pending(self) -> tuple[Pending, ...]:
        """Versions that wait for approvals."""

    def deprecations(self) -> tuple[Deprecation, ...]:
        """Deprecated versions, and the owners that use them."""

    def acknowledge(self, kind: Kind, reference: Reference, owner: str) -> Change:
        """Record that an owner knows of a deprecation."""

    def record(self, action: Action, line: str, reference: Reference) -> Change:
        """Record a deployment, a release or the end of support."""

    def set_state(self, kind: Kind, reference: Reference, state: State, until: str = "", successor: str = "") -> Change:
        """Deprecate or retire a version."""

    def set_rule(self, kind: Kind, name: str, rule: Rule) -> Change:
        """Set the rule of a name."""

    def approve(self, kind: Kind, reference: Reference, owner: str, days: int, content: str) -> tuple[Decided, Change]:
        """Approve the content of a pending version, and return all decisions."""

    def reject(self, kind: Kind, reference: Reference, owner: str, reason: str, content: str) -> tuple[Decided, Change]:
        """Reject the content of a pending version, and return all decisions."""
