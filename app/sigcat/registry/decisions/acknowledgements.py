"""Acknowledgements of a deprecation by the owners of the functions that use the version."""

import json
from collections.abc import Iterator
from typing import NamedTuple

from sqlalchemy import Connection, select

from sigcat.findings import shown
from sigcat.names import did_you_mean
from sigcat.registry.decisions.approvals import check_author, unfit
from sigcat.registry.published import Published, all_versions, version_named
from sigcat.registry.reference import Kind, Reference
from sigcat.registry.storing.content import content_of
from sigcat.registry.storing.ledger import Registry, ledger_of
from sigcat.registry.storing.tables import ACKNOWLEDGEMENTS
from sigcat.registry.use import from_json
from sigcat.registry.users import direct_users


class Acknowledgement(NamedTuple):
    """An owner of functions that use a deprecated version."""

    owner: str
    functions: str
    """These functions, with their versions."""
    at: str
    """Time at which the owner acknowledged the deprecation; empty as long as it did not."""

    @property
    def sentence(self) -> str:
        """The state of the acknowledgement."""
        if self.at:
            return f"{self.owner} acknowledged it on {self.at[:10]}"
        return f"{self.owner} has not acknowledged it: it is used by {self.functions}"


class Deprecation(NamedTuple):
    """A deprecated version, and the owners that use it."""

    published: Published
    acknowledgements: tuple[Acknowledgement, ...]


def deprecations(connection: Connection) -> tuple[Deprecation, ...]:
    """Deprecated versions by kind, name and precedence."""
    found = (each for each in all_versions(connection) if each.state == "deprecated")
    return tuple(Deprecation(each, acknowledgements_of(connection, each)) for each in found)


def acknowledgements_of(connection: Connection, version: Published) -> tuple[Acknowledgement, ...]:
    """Other owners whose current functions use a version, and those that acknowledged its deprecation, by name."""
    functions: dict[str, set[str]] = {}
    for user in direct_users(connection, list(_elements(connection, version))):
        if user.owner != version.owner and user.name != version.name:
            functions.setdefault(user.owner, set()).add(str(user.reference))
    columns = (ACKNOWLEDGEMENTS.c.owner, ACKNOWLEDGEMENTS.c.at)
    rows = connection.execute(select(*columns).where(ACKNOWLEDGEMENTS.c.version_id == version.id))
    times = {row.owner: row.at for row in rows}
    owners = sorted({*functions, *times})
    return tuple(
        Acknowledgement(each, ", ".join(sorted(functions.get(each, ()))), times.get(each, "")) for each in owners
    )


def _elements(connection: Connection, version: Published) -> Iterator[str]:
    """Parts of a version that others may use: the outputs of a function, the nodes of a catalogue or an overlay."""
    if version.kind == "function":
        uses = from_json(content_of(connection, version.uses))
        yield from dict.fromkeys(use.element for use in uses if use.provides)
    else:
        yield from json.loads(content_of(connection, version.resolved))


def acknowledge(registry: Registry, kind: Kind, reference: Reference, owner: str) -> str:
    """Record that an owner knows of a deprecation, and return the head of the log. Raises InputRefused."""
    check_author(registry, reference, owner)
    with ledger_of(registry) as ledger:
        version = version_named(ledger.connection, kind, reference)
        if version.state != "deprecated":
            raise unfit(reference, f"{reference} must be deprecated to be acknowledged; it is {version.state}.")
        known = {each.owner: each for each in acknowledgements_of(ledger.connection, version)}
        if owner not in known:
            whose = f" ({', '.join(known)})" if known else ": there is none"
            message = f"The owner must be one whose functions use {reference}{whose}, not {shown(owner)}."
            raise unfit(reference, message, did_you_mean(owner, known))
        if not known[owner].at:
            ledger.append("acknowledge", {"kind": kind, **reference._asdict(), "owner": owner})
        return ledger.head_hash
