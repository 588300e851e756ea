"""Inputs of a run of the gateway are read and compared: the database, and the mappings of the catalogue."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat import codes
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.network.can_database import CanDatabase, of_channels, read_can_database
from sigcat.catalogue.network.mapped_signals import Mapped, mapped_signals
from sigcat.catalogue.network.sent_numbers import Outgoing, outgoing_signals
from sigcat.errors import InputRefused
from sigcat.findings import Finding, has_errors, in_order
from sigcat.rules.mapping_findings import mapping_findings


class Prepared(NamedTuple):
    """A database, and the signals that come from it."""

    database: CanDatabase
    mapped: tuple[Mapped, ...]
    outgoing: tuple[Outgoing, ...]
    """The signals that go to it."""
    findings: tuple[Finding, ...]
    """Warnings of the linter about the mappings."""
    datatypes: Mapping[str, str]
    """Mappings of every signal, by path."""


def prepare(
    catalogue: Catalogue, databases: Sequence[Path | tuple[str, Path]], *, is_sending: bool = False
) -> Prepared:
    """Everything that is there before the first frame; a database may be of a channel.

    Raises InputRefused with all errors of the mappings.
    """
    by_channel: dict[str, list[Path]] = {}
    for each in databases:
        channel, path = each if isinstance(each, tuple) else ("", each)
        by_channel.setdefault(channel, []).append(path)
    database = of_channels({channel: read_can_database(paths) for channel, paths in by_channel.items()})
    if has_errors(database.findings):
        raise InputRefused("The CAN database cannot be used.", database.findings)
    mapped = mapped_signals(catalogue)
    outgoing = outgoing_signals(catalogue)
    findings = in_order(list(mapping_findings(catalogue, database)))
    if has_errors(findings):
        raise InputRefused("The mappings cannot be used.", findings)
    if not (outgoing if is_sending else mapped):
        own = "vss2dbc" if is_sending else "dbc2vss"
        fix = f"Name the overlay that has `network_serialization` or `{own}` with -l."
        finding = codes.NOTHING_MAPPED.finding("The catalogue maps no signal to CAN.", _name_of(catalogue), fix=fix)
        raise InputRefused("There is nothing to do.", (*findings, finding))
    datatypes = {path: str(node.values["datatype"]) for path, node in catalogue.nodes.items() if node.is_leaf}
    return Prepared(database, mapped, outgoing, (*database.findings, *findings), datatypes)


def _name_of(catalogue: Catalogue) -> str:
    layers = catalogue.tree_layers
    return layers[-1].name if layers else ""
