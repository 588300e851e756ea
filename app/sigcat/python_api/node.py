"""A node of a catalogue, with every attribute and where it was written."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    from sigcat.catalogue.model import catalogue as model
    from sigcat.catalogue.reading.statement import Origin


class Attribute(NamedTuple):
    """An attribute of a node."""

    name: str
    value: Any
    origin: "Origin"
    """Place where the value was written."""
    history: "tuple[tuple[Any, Origin], ...]"
    """Every value that the tree and its overlays gave it, first to last."""


@dataclass(frozen=True)
class Node:
    """A branch, signal, struct or property of a catalogue. Frozen."""

    path: str
    _catalogue: "model.Catalogue" = field(repr=False)

    @property
    def name(self) -> str:
        """Last name of the path."""
        return self._node.name

    @property
    def type(self) -> str:
        """branch, sensor, actuator, attribute, struct or property."""
        return self._node.type

    @property
    def datatype(self) -> str:
        """VSS datatype; empty for branches."""
        return self._text("datatype")

    @property
    def unit(self) -> str:
        """Unit as it is written; empty without one."""
        return self._text("unit")

    @property
    def description(self) -> str:
        """Description as it is written."""
        return self._text("description")

    @property
    def values(self) -> Mapping[str, Any]:
        """Values of all attributes by name, such as `min`, `max`, `allowed` and extended attributes."""
        return self._node.values

    @property
    def attributes(self) -> Mapping[str, Attribute]:
        """All attributes by name, with their origin."""
        definition = self._node.definition
        return {
            name: Attribute(name, value, definition.origin(name), definition.history(name))
            for name, value in self._node.values.items()
        }

    @property
    def origin(self) -> "Origin":
        """Place where the node was written first."""
        return self._node.definition.origin()

    @property
    def definition_path(self) -> str:
        """Path without the names of instances; the path itself for other nodes."""
        return self._node.template

    @property
    def parent(self) -> "Node | None":
        """The branch above; None above a root."""
        above = self._catalogue.parent(self._node)
        return Node(above.path, self._catalogue) if above else None

    @property
    def children(self) -> "tuple[Node, ...]":
        """Nodes directly below, in the order of the files."""
        return tuple(Node(child.path, self._catalogue) for child in self._node.children)

    def walk(self) -> "Iterator[Node]":
        """Iterate over this node and all nodes below it, parents first."""
        return (Node(node.path, self._catalogue) for node in self._node.walk())

    @property
    def _node(self) -> "model.Node":
        return self._catalogue.nodes[self.path]

    def _text(self, name: str) -> str:
        return str(self._node.values.get(name) or "")

    def _repr_html_(self) -> str:
        from sigcat.python_api.html import node_html

        return node_html(self._node)
