"""The catalogue: a frozen tree of nodes, found by path."""

from collections.abc import Collection, Iterator, Mapping
from functools import cached_property
from types import MappingProxyType
from typing import Any, NamedTuple

from app.catalogue.definition import Definition
from app.catalogue.layers import Layer
from app.catalogue.vocabulary import Unit, Vocabulary
from app.catalogue.vspec_file import Origin
from app.findings import Finding
from app.names import last_name, parent_path


class Node(NamedTuple):
    """A node of the tree. Instances of a branch share the definitions of what stands below them."""

    path: str
    definition: Definition
    children: tuple["Node", ...]

    @property
    def name(self) -> str:
        """Last name of the path."""
        return last_name(self.path)

    @property
    def type(self) -> str:
        """branch, sensor, actuator, attribute, struct or property."""
        return self.definition.type

    @property
    def values(self) -> Mapping[str, Any]:
        """Attributes by name."""
        return self.definition.values

    @property
    def is_leaf(self) -> bool:
        """Whether the node has a datatype, so holds a value."""
        return "datatype" in self.definition.values

    @property
    def template(self) -> str:
        """Path of the definition: for an instance, the path without the names of instances."""
        return self.definition.path

    def __repr__(self) -> str:
        return f"<Node {self.path}>"

    def walk(self) -> Iterator["Node"]:
        """This node and all below it, parents first, in the order of the files."""
        waiting = [self]
        while waiting:
            node = waiting.pop()
            yield node
            waiting.extend(reversed(node.children))


class Catalogue:
    """A composed tree with its vocabulary, its layers and everything that was wrong with them. Frozen."""

    def __init__(
        self,
        name: str,
        roots: tuple[Node, ...],
        vocabulary: Vocabulary,
        layers: tuple[Layer, ...],
        findings: tuple[Finding, ...],
        definitions: Mapping[str, Definition],
        is_expanded: bool,
    ) -> None:
        self.name = name
        self.roots = roots
        """The signal tree, if there is one, and after it the tree of struct types."""
        self.vocabulary = vocabulary
        self.layers = layers
        self.findings = findings
        self.definitions = definitions
        """Merged definitions by path, before expansion."""
        self.is_expanded = is_expanded
        self.nodes: Mapping[str, Node] = MappingProxyType({n.path: n for root in roots for n in root.walk()})
        """Every node by path, parents first."""

    def __repr__(self) -> str:
        return f"<Catalogue {self.name}: {len(self.nodes)} nodes>"

    @property
    def tree_layers(self) -> tuple[Layer, ...]:
        """The base of the signal tree and its overlays, in the order in which they apply."""
        return (*self.layers[:1], *(layer for layer in self.layers[1:] if layer.is_overlay))

    @property
    def overlays(self) -> tuple[Layer, ...]:
        """Overlays in the order in which they apply."""
        return tuple(layer for layer in self.layers if layer.is_overlay)

    @property
    def type_layers(self) -> tuple[Layer, ...]:
        """The trees of struct types."""
        return tuple(layer for layer in self.layers[1:] if not layer.is_overlay)

    def with_findings(self, findings: tuple[Finding, ...]) -> "Catalogue":
        """The same catalogue with other findings."""
        return self._with(self.roots, findings, self.is_expanded)

    def with_roots(self, roots: tuple[Node, ...], *, is_expanded: bool) -> "Catalogue":
        """The same definitions with other nodes made of them."""
        return self._with(roots, self.findings, is_expanded)

    def get(self, path: str) -> Node | None:
        """The node at a path, or None."""
        return self.nodes.get(path)

    def parent(self, node: Node) -> Node | None:
        """The branch above a node; None above a root."""
        return self.nodes.get(parent_path(node.path))

    def unit(self, node: Node) -> Unit | None:
        """The unit of a node's values."""
        key = node.values.get("unit")
        return self.vocabulary.unit(key) if isinstance(key, str) else None

    def origin(self, node: Node, attribute: str = "") -> Origin:
        """Where an attribute of a node was last written, or the node itself."""
        return node.definition.origin(attribute)

    def written_in(self, files: Collection[str]) -> Iterator[Definition]:
        """Definitions of which at least one of the files speaks."""
        for definition in self.definitions.values():
            for statement in definition.statements:
                if statement.file.name in files:
                    yield definition
                    break

    def _with(self, roots: tuple[Node, ...], findings: tuple[Finding, ...], is_expanded: bool) -> "Catalogue":
        return Catalogue(self.name, roots, self.vocabulary, self.layers, findings, self.definitions, is_expanded)

    @cached_property
    def digest(self) -> str:
        """SHA-256 of the content: equal for equal trees, however they are split into files and layers."""
        import hashlib
        import json

        sha = hashlib.sha256()
        known: dict[int, bytes] = {}
        for path, node in self.nodes.items():
            key = id(node.definition)
            if key not in known:
                text = json.dumps(node.values, sort_keys=True, default=str, ensure_ascii=False)
                known[key] = hashlib.sha256(text.encode("utf-8", "surrogatepass")).digest()
            sha.update(path.encode("utf-8", "surrogatepass") + b"\0" + known[key])
        for unit in self.vocabulary.distinct_units:
            sha.update(repr(unit[:6]).encode("utf-8", "surrogatepass"))
        return sha.hexdigest()
