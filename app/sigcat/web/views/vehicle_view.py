"""Vehicles of a catalogue, ready to be shown: the matrix, its filters, and the vehicles that have a node."""

from collections.abc import Iterator, Mapping, Sequence
from functools import lru_cache
from typing import NamedTuple

from sigcat.api.answers.schemas import Finding as ShownFinding
from sigcat.api.answers.serializers import finding_schema
from sigcat.catalogue.hosting.library import Hosted, Library
from sigcat.catalogue.hosting.variants import Choice, choice_of, vehicle_matrix
from sigcat.catalogue.hosting.vehicle_matrix import Filters, Matrix, Row, filtered, label_values
from sigcat.catalogue.model.vehicle import Vehicle
from sigcat.limits import PAGE_FINDINGS

_ROWS = 150
"""Nodes on one page."""
_COLUMNS = 60
"""Vehicles on one page; the filters choose others."""
_BETWEEN = ":"
"""Between the name and the value of a fact in an address."""


class InVehicle(NamedTuple):
    """A vehicle, whether it has a node, and the id of its catalogue."""

    vehicle: Vehicle
    has: bool
    catalogue: str


class Fact(NamedTuple):
    """A fact of vehicles, with its values."""

    name: str
    values: tuple[str, ...]
    chosen: str


class VehicleView(NamedTuple):
    """A part of the matrix."""

    columns: tuple[tuple[Vehicle, str], ...]
    """Vehicles with the ids of their catalogues."""
    rows: tuple[Row, ...]
    total: int
    """Rows of all pages."""
    vehicle_count: int
    """Vehicles that the filters leave, of which the page shows the first."""
    facts: tuple[Fact, ...]
    start: int
    following: int
    """First row of the next page; 0 on the last."""
    errors: tuple[ShownFinding, ...]
    """Errors of the vehicles."""

    @property
    def previous(self) -> int:
        """First row of the page before."""
        return max(self.start - _ROWS, 0)


def base_of(library: Library, hosted: Hosted) -> Hosted:
    """The catalogue of which vehicles are composed."""
    return library.get(choice_of(hosted.source.id).base)


def filters_of(text: str, facts: Sequence[str], *, is_all: bool) -> Filters:
    """Return the filters of an address."""
    pairs = (fact.partition(_BETWEEN) for fact in facts)
    return Filters(text, is_all, labels=tuple((name, value) for name, _, value in pairs if value))


def chosen_matrix(base: Hosted, filters: Filters) -> Matrix:
    """Return the part of the matrix that the filters leave."""
    return filtered(vehicle_matrix(base.catalogue, base.source), filters)


def vehicle_view(base: Hosted, filters: Filters, start: int) -> VehicleView:
    """Return a page of the matrix."""
    matrix = chosen_matrix(base, filters)
    columns = tuple((each, _id(base, each)) for each in matrix.vehicles[:_COLUMNS])
    rows = tuple(row._replace(has=row.has[:_COLUMNS]) for row in matrix.rows[start : start + _ROWS])
    following = start + _ROWS if start + _ROWS < len(matrix.rows) else 0
    chosen = dict(filters.labels)
    facts = tuple(Fact(*fact, chosen.get(fact[0], "")) for fact in _telling_facts(base.source.vehicles))
    errors = tuple(map(finding_schema, matrix.errors[:PAGE_FINDINGS]))
    return VehicleView(columns, rows, len(matrix.rows), len(matrix.vehicles), facts, start, following, errors)


def vehicles_of(base: Hosted, path: str) -> tuple[InVehicle, ...]:
    """Return the vehicles of a catalogue, and whether each has a node; none for a node that is not in the matrix."""
    if not base.source.vehicles:
        return ()
    matrix = vehicle_matrix(base.catalogue, base.source)
    has = _by_path(matrix).get(path, ())
    return tuple(InVehicle(each, it, _id(base, each)) for each, it in zip(matrix.vehicles, has, strict=False))


def _telling_facts(vehicles: Sequence[Vehicle]) -> Iterator[tuple[str, tuple[str, ...]]]:
    """Yield the facts in which vehicles differ, with their values."""
    for name, values in label_values(vehicles).items():
        if len(values) > 1 or any(name not in dict(vehicle.labels) for vehicle in vehicles):
            yield name, tuple(values)


@lru_cache(maxsize=4)
def _by_path(matrix: Matrix) -> Mapping[str, tuple[bool, ...]]:
    return {row.path: row.has for row in matrix.rows}


def _id(base: Hosted, vehicle: Vehicle) -> str:
    return Choice(base.source.id, vehicle=vehicle.name).id
