"""The catalogue: a frozen tree of nodes, found by path."""

from collections import ChainMap
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import cached_property
from types import MappingProxyType
from typing import Any, NamedTuple, TypeVar

from sigcat.catalogue.model.definition import BRANCH, SIGNALS, Definition
from sigcat.catalogue.model.interfaces import category_of, interface_name
from sigcat.catalogue.model.vocabulary import Unit, Vocabulary
from sigcat.catalogue.reading.layers import Layer
from sigcat.catalogue.reading.statement import Origin, SourceFile
from sigcat.findings import Finding
from sigcat.limits import DEFAULT_LIMITS
from sigcat.names import is_well_formed, last_name, parent_path

Value = TypeVar("Value")


class Node(NamedTuple):
    """A node of the tree. Instances of a branch share the definitions of the nodes below them."""

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

    def __repr__(self) -> str:
        return f"<Catalogue {self.name}: {len(self.nodes)} nodes>"

    @cached_property
    def nodes(self) -> Mapping[str, Node]:
        """Every node by path, parents first."""
        return MappingProxyType({node.path: node for root in self.roots for node in root.walk()})

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

    @property
    def files(self) -> tuple[SourceFile, ...]:
        """Every file that was read: those of the layers, of units and of quantities."""
        return (*(file for layer in self.layers for file in layer.files), *self.vocabulary.files)

    @property
    def has_signals(self) -> bool:
        """Whether there is a sensor, an actuator or an attribute."""
        return any(definition.type in SIGNALS for definition in self.definitions.values())

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

    def beside(self, node: Node) -> tuple[Node | None, Node | None]:
        """The siblings before and after a node."""
        parent = self.parent(node)
        siblings = parent.children if parent else self.roots
        position = self._positions[node.path]
        before = siblings[position - 1] if position else None
        return before, siblings[position + 1] if position + 1 < len(siblings) else None

    @cached_property
    def _positions(self) -> Mapping[str, int]:
        """The place of each node among its siblings."""
        families = (self.roots, *(node.children for node in self.nodes.values()))
        return {node.path: position for family in families for position, node in enumerate(family)}

    def unit(self, node: Node) -> Unit | None:
        """The unit of a node's values."""
        key = node.values.get("unit")
        return self.vocabulary.unit(key) if isinstance(key, str) else None

    def origin(self, node: Node, attribute: str = "") -> Origin:
        """Return the last place of an attribute of a node, or the place of the node itself."""
        return node.definition.origin(attribute)

    def written_in(self, files: Collection[str]) -> Iterator[Definition]:
        """Definitions of which at least one of the files speaks."""
        for definition in self.definitions.values():
            for statement in definition.statements:
                if statement.file.name in files:
                    yield definition
                    break

    @cached_property
    def interfaces(self) -> Mapping[str, Definition]:
        """Definitions of error, safety reaction, mode and scheduling interfaces by interface name; the first counts."""
        return _interfaces(self.definitions, {})

    @cached_property
    def first_spellings(self) -> Mapping[str, str]:
        """Return the first of paths that differ in case only, by the path in lower case."""
        return _first_spellings(self.definitions)

    @cached_property
    def attributes(self) -> frozenset[str]:
        """Names of all attributes that nodes have."""
        return frozenset(name for definition in self.definitions.values() for name in definition.values)

    @cached_property
    def positions(self) -> Mapping[str, int]:
        """The number of each definition in the order of all, by path."""
        return {path: position for position, path in enumerate(self.definitions)}

    @cached_property
    def overlaid(self) -> Collection[Definition]:
        """Definitions of which an overlay speaks last."""
        return [d for d in self.definitions.values() if d.statements and d.statements[-1].file.overlay]

    @cached_property
    def children(self) -> Mapping[str, Sequence[Definition]]:
        """Definitions right below a path, by that path."""
        return {path: list(below.values()) for path, below in _by_parent(self.definitions).items()}

    @cached_property
    def first_below(self) -> Mapping[str, Definition]:
        """For each path above a definition, also for one that no file defines, the first definition below it.

        Malformed paths have no place in the tree, and do not count.
        """
        found: dict[str, Definition] = {}
        for path, definition in self.definitions.items():
            above = parent_path(path) if is_well_formed(path, DEFAULT_LIMITS.path_names) else ""
            while above and above not in found:
                found[above] = definition
                above = parent_path(above)
        return found

    @cached_property
    def branches(self) -> Mapping[str, Sequence[Definition]]:
        """Definitions of branches by the path of the branch right above them."""
        branches: dict[str, list[Definition]] = {}
        for path, definition in self.definitions.items():
            if definition.type == BRANCH:
                branches.setdefault(parent_path(path), []).append(definition)
        return branches

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
            sha.update(repr(unit.meaning).encode("utf-8", "surrogatepass"))
        return sha.hexdigest()


class CataloguePart(Catalogue):
    """A catalogue with an overlay, as far as it reaches. Facts about the catalogue are not computed again."""

    def __init__(
        self,
        below: Catalogue,
        overlay: Layer,
        roots: tuple[Node, ...],
        findings: tuple[Finding, ...],
        changed: Mapping[str, Definition],
    ) -> None:
        definitions = over(below.definitions, changed)
        layers = (*below.layers, overlay)
        super().__init__(below.name, roots, below.vocabulary, layers, findings, definitions, is_expanded=False)
        self.below = below
        self.changed = changed
        """Merged definitions of which the overlay speaks."""

    @cached_property
    def overlaid(self) -> Collection[Definition]:
        """Definitions of which this overlay speaks."""
        return self.changed.values()

    @cached_property
    def interfaces(self) -> Mapping[str, Definition]:
        """Definitions of error, safety reaction, mode and scheduling interfaces by interface name; the first counts."""
        return _interfaces(self.changed, self.below.interfaces)

    @cached_property
    def children(self) -> Mapping[str, Sequence[Definition]]:
        """Definitions right below a path, by that path."""
        changed = {
            path: list(({each.path: each for each in self.below.children.get(path, ())} | own).values())
            for path, own in _by_parent(self.changed).items()
        }
        return over(self.below.children, changed)

    @cached_property
    def first_spellings(self) -> Mapping[str, str]:
        """Return the first of paths that differ in case only, by the path in lower case."""
        return over(_first_spellings(self.changed), self.below.first_spellings)


def over(below: Mapping[str, Value], above: Mapping[str, Value]) -> Mapping[str, Value]:
    """Two mappings as one. To copy a whole tree costs more than all that an overlay asks of it."""
    return ChainMap(above, below)  # type: ignore[arg-type] # it is only read


def _by_parent(definitions: Mapping[str, Definition]) -> Mapping[str, dict[str, Definition]]:
    found: dict[str, dict[str, Definition]] = {}
    for path, definition in definitions.items():
        found.setdefault(parent_path(path), {})[path] = definition
    return found


def _interfaces(definitions: Mapping[str, Definition], below: Mapping[str, Definition]) -> Mapping[str, Definition]:
    found = dict(below)
    for path, definition in definitions.items():
        if category_of(path) not in (None, "data"):
            name = interface_name(path)
            if name not in found or found[name].path == path:
                found[name] = definition
    return found


def _first_spellings(paths: Iterable[str]) -> dict[str, str]:
    first: dict[str, str] = {}
    for path in paths:
        first.setdefault(path.lower(), path)
    return first
