"""Two nodes side by side: every attribute of both, what differs, and the class of each difference."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from sigcat.api.answers.serializers import shown_file
from sigcat.catalogue.comparing.changes import CLASSES, same
from sigcat.catalogue.comparing.compatibility import Vocabularies, attribute_changes
from sigcat.catalogue.comparing.instance_changes import instances_as_written
from sigcat.catalogue.hosting.library import Hosted
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.definition import CORE_ATTRIBUTES
from sigcat.catalogue.reading.statement import Origin
from sigcat.catalogue.search import overlay_name
from sigcat.function.node_uses import NodeUse
from sigcat.web.views.node_view import ordered
from sigcat.web.views.signal_conversions import from_unit_to_unit

MOST_CHILDREN = 400
"""Rows of nodes below two branches."""
_MOST_NEAR = 12


class Side(NamedTuple):
    """One of two nodes. Without a node, `near` are paths that may have been meant."""

    hosted: Hosted
    path: str
    node: Node | None = None
    near: tuple[str, ...] = ()
    uses: Sequence[NodeUse] = ()


class Cell(NamedTuple):
    """The value of an attribute on one side, and where it was written."""

    value: Any
    origin: Origin


class Row(NamedTuple):
    """An attribute on both sides; None where a side does not have it."""

    name: str
    left: Cell | None
    right: Cell | None
    differs: bool
    compatibility: str
    """Class of the change from left to right; empty if it has none."""
    is_extended: bool

    @property
    def cells(self) -> tuple[Cell | None, Cell | None]:
        """Both sides."""
        return self.left, self.right


class ChildRow(NamedTuple):
    """A node below two branches, by its name."""

    name: str
    left: Node | None
    right: Node | None
    differs: bool


class NodeComparison(NamedTuple):
    """Two nodes, ready to be shown."""

    rows: tuple[Row, ...]
    difference_count: int
    classes: tuple[tuple[str, int], ...]
    """Number of differences of each class that has some."""
    conversion: str
    """From the unit of the left node to that of the right one; empty without one."""
    children: tuple[ChildRow, ...]
    child_count: int


class Elsewhere(NamedTuple):
    """A node of another catalogue at the same path."""

    hosted: Hosted
    difference_count: int


def compare_nodes(left: Side, right: Side) -> NodeComparison:
    """Compare two nodes, attribute by attribute."""
    assert left.node is not None
    assert right.node is not None
    vocabularies = Vocabularies(left.hosted.catalogue.vocabulary, right.hosted.catalogue.vocabulary)
    rows = tuple(_rows(left.node, right.node, vocabularies))
    classes = [row.compatibility for row in rows if row.differs]
    children = tuple(_children(left.node, right.node))
    return NodeComparison(
        rows,
        len(classes),
        tuple((name, number) for name in CLASSES if (number := classes.count(name))),
        _conversion(left.node, right.node),
        children[:MOST_CHILDREN],
        len(children),
    )


def same_path_elsewhere(library: Iterable[Hosted], side: Side) -> Iterator[Elsewhere]:
    """Yield the other catalogues that have the path, with the number of differences."""
    for hosted in library:
        node = hosted.catalogue.get(side.path)
        if node is not None and side.node is not None and hosted.source.id != side.hosted.source.id:
            yield Elsewhere(hosted, sum(row.differs for row in _rows(side.node, node, _NO_VOCABULARIES)))


def same_name_elsewhere(catalogue: Catalogue, node: Node) -> tuple[str, ...]:
    """Return paths of other nodes of the same name, those of instances once."""
    ending = f".{node.name}"
    known = {node.template}
    found = []
    for path, other in catalogue.nodes.items():
        if path.endswith(ending) and other.template not in known:
            known.add(other.template)
            found.append(path)
    return tuple(found[:_MOST_NEAR])


_NO_VOCABULARIES = Vocabularies()


def _rows(left: Node, right: Node, vocabularies: Vocabularies) -> Iterator[Row]:
    changes = {change.name: change for change in attribute_changes(left.values, right.values, vocabularies)}
    for name in ordered({**_values(left), **_values(right)}):
        first, second = _cell(left, name), _cell(right, name)
        differs = first is None or second is None or not same(first.value, second.value)
        compatibility = changes[name].compatibility if differs and name in changes else ""
        yield Row(name, first, second, differs, compatibility, name not in CORE_ATTRIBUTES)


def _cell(node: Node, name: str) -> Cell | None:
    values = _values(node)
    if name not in values:
        return None
    origin = node.definition.origin(name)
    return Cell(values[name], origin._replace(file=shown_file(origin.file), overlay=overlay_name(origin.overlay)))


def _values(node: Node) -> Mapping[str, Any]:
    """Attributes of a node. Those of a branch have no `instances` once they are expanded."""
    written = None if node.is_leaf or node.definition.is_instance else instances_as_written(node)
    return node.values if written is None else {**node.values, "instances": written}


def _conversion(left: Node, right: Node) -> str:
    units = left.values.get("unit"), right.values.get("unit")
    return from_unit_to_unit(*map(str, units)) if all(units) else ""


def _children(left: Node, right: Node) -> Iterator[ChildRow]:
    """Yield the names below either branch, those of the left one first."""
    before, after = ({child.name: child for child in node.children} for node in (left, right))
    for name in {**before, **after}:
        first, second = before.get(name), after.get(name)
        differs = first is None or second is None or not same(dict(first.values), dict(second.values))
        yield ChildRow(name, first, second, differs)
