"""Compare vehicles node by node: which of them have a node."""

import csv
from collections.abc import Iterable, Iterator, Sequence
from io import StringIO
from typing import NamedTuple

from sigcat.catalogue.hosting.vehicles import Composed
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.vehicle import Vehicle
from sigcat.findings import Finding


class Row(NamedTuple):
    """A node, and which vehicles have it."""

    path: str
    type: str
    has: tuple[bool, ...]
    """In the order of the vehicles."""
    is_cause: bool
    """Whether vehicles differ here already, and not only above."""
    signals: int
    """Signals at or below the node, in the vehicle with most of them."""


class Matrix(NamedTuple):
    """Nodes of a catalogue and its vehicles."""

    vehicles: tuple[Vehicle, ...]
    rows: tuple[Row, ...]
    errors: tuple[Finding, ...] = ()
    """Errors of the vehicles, once each."""


class Filters(NamedTuple):
    """The part of a matrix to show."""

    text: str = ""
    """Words that a path has, in upper or lower case."""
    is_all: bool = False
    """Whether nodes in which vehicles do not differ are shown too."""
    vehicles: frozenset[str] = frozenset()
    """Names of vehicles; empty: all."""
    labels: tuple[tuple[str, str], ...] = ()
    """Facts that each vehicle has."""


def matrix_of(composed: Sequence[Composed]) -> Matrix:
    """Return the matrix of vehicles. Nodes of their catalogues that no vehicle has are rows too."""
    bases = {id(each.below): each.below for each in composed}.values()
    roots = [_root(catalogue) for catalogue in (*bases, *(each.catalogue for each in composed))]
    rows: list[Row] = []
    for path in dict.fromkeys(root.path for root in roots if root is not None):
        family = _family([root if root is not None and root.path == path else None for root in roots], len(bases))
        rows.extend(_rows(family, family.has))
    errors = dict.fromkeys(error for each in composed for error in each.errors)
    return Matrix(tuple(each.vehicle for each in composed), tuple(rows), tuple(errors))


def _root(catalogue: Catalogue) -> Node | None:
    """The root of the signal tree; None where it could not be read."""
    return next(iter(catalogue.roots), None)


class _Family(NamedTuple):
    """The nodes at one path. Vehicles share most of them, so each is held once."""

    nodes: Sequence[Node]
    which: Sequence[int]
    """For each catalogue and each vehicle, the index of its node, or -1."""
    catalogues: int

    @property
    def has(self) -> tuple[bool, ...]:
        return tuple(index >= 0 for index in self.which[self.catalogues :])


def _family(members: Sequence[Node | None], catalogues: int) -> _Family:
    nodes: dict[int, Node] = {id(node): node for node in members if node is not None}
    indexes = {key: index for index, key in enumerate(nodes)}
    return _Family(list(nodes.values()), [-1 if node is None else indexes[id(node)] for node in members], catalogues)


def _rows(family: _Family, above: tuple[bool, ...]) -> Iterator[Row]:
    """Yield the row of a node, and those of all nodes below it."""
    first, has = family.nodes[0], family.has
    yield Row(first.path, first.type, has, has != above, max(map(_signals, family.nodes)))
    children = [{child.path: child for child in node.children} for node in family.nodes]
    if len(family.nodes) == 1:
        yield from (
            Row(node.path, node.type, has, False, _signals(node)) for each in first.children for node in each.walk()
        )
        return
    for path in dict.fromkeys(path for each in children for path in each):
        members = [children[index].get(path) if index >= 0 else None for index in family.which]
        yield from _rows(_family(members, family.catalogues), has)


def _signals(node: Node) -> int:
    return sum(each.is_leaf for each in node.walk())


def filtered(matrix: Matrix, filters: Filters) -> Matrix:
    """Return the vehicles and nodes that the filters leave."""
    kept = [number for number, vehicle in enumerate(matrix.vehicles) if _is_chosen(vehicle, filters)]
    words = filters.text.lower().split()
    vehicles = tuple(matrix.vehicles[number] for number in kept)
    rows = (row._replace(has=tuple(row.has[number] for number in kept)) for row in matrix.rows)
    shown = (row for row in rows if filters.is_all or (row.is_cause and not all(row.has)))
    found = tuple(row for row in shown if all(word in row.path.lower() for word in words))
    return Matrix(vehicles, found, matrix.errors)


def _is_chosen(vehicle: Vehicle, filters: Filters) -> bool:
    is_named = not filters.vehicles or not filters.vehicles.isdisjoint((vehicle.id, vehicle.name))
    return is_named and all(label in vehicle.labels for label in filters.labels)


def label_values(vehicles: Iterable[Vehicle]) -> dict[str, list[str]]:
    """Return the values of each fact that a vehicle has, for filters."""
    found: dict[str, dict[str, None]] = {}
    for vehicle in vehicles:
        for name, value in vehicle.labels:
            found.setdefault(name, {})[value] = None
    return {name: list(values) for name, values in found.items()}


def matrix_csv(matrix: Matrix) -> str:
    """Return the matrix as CSV: a row for each node, a column for each vehicle, 1 where it has the node."""
    text = StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow(["path", "type", "signals", *(vehicle.name for vehicle in matrix.vehicles)])
    for row in matrix.rows:
        table.writerow([row.path, row.type, row.signals, *(int(has) for has in row.has)])
    return text.getvalue()
