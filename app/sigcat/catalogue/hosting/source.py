"""Source of one catalogue: a tree, its overlays in order, and its vocabulary."""

from pathlib import Path
from typing import NamedTuple, Protocol

from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.catalogue.composing.older_releases import ESSENTIAL
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.vehicle import Vehicle
from sigcat.findings import Finding
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.real_path import each_once


class Severities(Protocol):
    """Severities that a project sets."""

    def graded(self, finding: Finding) -> Finding | None:
        """Return the finding with its severity; None if its rule is off."""


class Source(NamedTuple):
    """Source of a catalogue: a tree, its overlays in order, and its vocabulary."""

    id: str
    """Name in addresses and on the command line."""
    title: str
    spec: Path
    overlays: tuple[Path, ...] = ()
    units: tuple[Path, ...] = ()
    quantities: tuple[Path, ...] = ()
    types: tuple[Path, ...] = ()
    include_dirs: tuple[Path, ...] = ()
    release: str = ""
    """Name of the official release that the tree is; its own errors are warnings. Empty: the user's own tree."""
    severities: Severities | None = None
    """Those that the project sets, in place of those of the rules."""
    has_standard_units: bool = True
    """Whether a tree without a file of units has those of VSS, and units may measure the quantities of VSS."""
    vehicles: tuple[Vehicle, ...] = ()
    """Vehicles that the project composes of this catalogue."""
    vehicle: Vehicle | None = None
    """The vehicle for which it is composed. Its overlays are among `overlays`."""

    def for_vehicle(self, vehicle: Vehicle) -> "Source":
        """Return the source of the catalogue of a vehicle."""
        overlays = each_once((*self.overlays, *vehicle.overlays))
        return self._replace(id=vehicle.label, title=vehicle.shown, overlays=overlays, vehicle=vehicle)


def load(source: Source, limits: Limits = DEFAULT_LIMITS, *, expanded: bool = True) -> Catalogue:
    """Read and compose the catalogue of a source, of whatever release it is."""
    catalogue = read_catalogue(
        source.spec,
        source.overlays,
        include_dirs=source.include_dirs,
        units=source.units,
        quantities=source.quantities,
        types=source.types,
        expanded=expanded,
        name=source.id,
        limits=limits,
        is_release=bool(source.release),
        has_standard_units=source.has_standard_units,
    )
    if source.vehicle is not None:
        from sigcat.catalogue.composing.configure import configured  # few commands name a vehicle

        catalogue = configured(catalogue, source.vehicle, limits)
    return catalogue if source.severities is None else graded(catalogue, source.severities)


def graded(catalogue: Catalogue, severities: Severities) -> Catalogue:
    """Return the catalogue with configured severities; an error that leaves no tree stays one."""
    each = ((finding if finding.rule in ESSENTIAL else severities.graded(finding)) for finding in catalogue.findings)
    findings = tuple(finding for finding in each if finding is not None)
    return catalogue if findings == catalogue.findings else catalogue.with_findings(findings)
