"""The CAN database and the mappings of the catalogue, for the bus of a deployment."""

from pathlib import Path
from typing import NamedTuple

from sigcat import codes
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.network.can_database import CanDatabase, read_can_database
from sigcat.catalogue.network.mapped_signals import Mapped, mapped_signals
from sigcat.catalogue.network.sent_numbers import Outgoing, outgoing_signals
from sigcat.errors import InputRefused
from sigcat.findings import Finding, has_errors, in_order
from sigcat.function.document.document import Pointer
from sigcat.integration.deployment import Deployment
from sigcat.rules.mapping_findings import mapping_findings


class Network(NamedTuple):
    """A CAN database, and the signals of the catalogue that are mapped to it."""

    database: CanDatabase
    mapped: tuple[Mapped, ...]
    outgoing: tuple[Outgoing, ...]
    findings: tuple[Finding, ...]
    """Warnings about the database and the mappings."""


def read_network(paths: tuple[str, ...], catalogue: Catalogue, deployment: Deployment) -> Network:
    """The network of a bus. Raises InputRefused if a database or a mapping cannot be used."""

    def unfit(at: Pointer, message: str, fix: str) -> Finding:
        return deployment.finding(codes.BUS_UNFIT, ("fmi", "bus", *at), message, fix, "")

    if not paths:
        finding = unfit((), "The bus must have a CAN database.", "Give `dbc` here, or in the project file.")
        raise InputRefused("The bus has no CAN database.", (finding,))
    missing = tuple(
        unfit(("dbc", index), f"The CAN database {path} must be a file.", "Correct the path.")
        for index, path in enumerate(paths)
        if not Path(path).is_file()
    )
    if missing:
        raise InputRefused("The CAN database cannot be used.", missing)
    database = read_can_database([Path(path) for path in paths])
    if has_errors(database.findings):
        raise InputRefused("The CAN database cannot be used.", database.findings)
    findings = in_order(list(mapping_findings(catalogue, database)))
    if has_errors(findings):
        raise InputRefused("The mappings cannot be used.", findings)
    return Network(database, mapped_signals(catalogue), outgoing_signals(catalogue), (*database.findings, *findings))
