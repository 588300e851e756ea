"""Compose the vehicles of one catalogue; what they do not change, they share."""

from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

from sigcat.catalogue.composing.compose_over import Known, compose_over, shared_nodes
from sigcat.catalogue.composing.configure import configured
from sigcat.catalogue.hosting.source import Source, graded, load
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.vehicle import Vehicle
from sigcat.catalogue.model.vocabulary import files_beside
from sigcat.catalogue.reading.layers import Layer, read_layer
from sigcat.file_kind import QUANTITY_NAMES, UNIT_NAMES
from sigcat.findings import Finding
from sigcat.limits import DEFAULT_LIMITS, Limits


class Composed(NamedTuple):
    """A vehicle and its catalogue."""

    vehicle: Vehicle
    catalogue: Catalogue
    below: Catalogue
    """The catalogue without the vehicle."""

    @property
    def errors(self) -> tuple[Finding, ...]:
        """Errors that only the vehicle has."""
        known = frozenset(self.below.findings)
        return tuple(each for each in self.catalogue.findings if each.severity == "error" and each not in known)


def composed_vehicles(
    base: Catalogue, source: Source, vehicles: Iterable[Vehicle], limits: Limits = DEFAULT_LIMITS
) -> Iterator[Composed]:
    """Yield each vehicle with its catalogue. `base` is the catalogue of `source`."""
    known = shared_nodes(base)
    layers: dict[Path, Layer] = {}
    for vehicle in vehicles:
        yield Composed(vehicle, _composed(base, source, vehicle, known, layers, limits), base)


def vehicle_of(base: Catalogue, source: Source, vehicle: Vehicle, limits: Limits = DEFAULT_LIMITS) -> Catalogue:
    """Return the catalogue of one vehicle, over the catalogue of `source`."""
    return next(composed_vehicles(base, source, (vehicle,), limits)).catalogue


def _composed(
    base: Catalogue, source: Source, vehicle: Vehicle, known: Known, layers: dict[Path, Layer], limits: Limits
) -> Catalogue:
    own = source.for_vehicle(vehicle)
    overlays = own.overlays[len(source.overlays) :]
    known_units = {file.name for file in base.vocabulary.files}
    if any(str(file) not in known_units for file in files_beside(overlays, (*UNIT_NAMES, *QUANTITY_NAMES))):
        return load(own, limits)  # they bring more units
    catalogue = base
    for path in overlays:
        if path not in layers:
            layers[path] = read_layer(path, source.include_dirs, is_overlay=True, limits=limits)
        catalogue = compose_over(catalogue, layers[path], limits, known)
    catalogue = configured(catalogue, vehicle, limits, known)
    return catalogue if source.severities is None else graded(catalogue, source.severities)
