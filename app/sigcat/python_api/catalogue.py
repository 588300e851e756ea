"""A catalogue: nodes by path, search, lint, trials of overlays, differences and functions."""

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, NamedTuple

from sigcat.python_api.node import Node
from sigcat.python_api.opening import PathLike

if TYPE_CHECKING:
    from sigcat.catalogue.comparing.changes import Change
    from sigcat.catalogue.comparing.sides import Release
    from sigcat.catalogue.hosting.source import Source
    from sigcat.catalogue.model import catalogue as model
    from sigcat.findings import Finding
    from sigcat.python_api.function import Function
    from sigcat.rules.linting.options import LintOptions


class Trial(NamedTuple):
    """The effect of an overlay. Nothing is stored."""

    catalogue: "Catalogue"
    """The catalogue with the overlay."""
    nodes: tuple[Node, ...]
    """Nodes that are new or have other attributes."""
    findings: "tuple[Finding, ...]"
    """Findings that the overlay adds."""
    changes: "tuple[Change, ...]"


class Catalogue:
    """A tree with its overlays, composed. Frozen; open it again to read changed files."""

    def __init__(self, composed: "model.Catalogue", title: str = "", lint: "LintOptions | None" = None) -> None:
        self._composed = composed
        self._lint = lint
        self._title = title

    @property
    def name(self) -> str:
        """Id of the catalogue in its project, else the name of the tree."""
        return self._composed.name

    @property
    def title(self) -> str:
        """Title for readers."""
        return self._title or self.name

    @property
    def roots(self) -> tuple[Node, ...]:
        """The root of the signal tree, and that of the struct types if there is one."""
        return tuple(Node(root.path, self._composed) for root in self._composed.roots)

    @property
    def findings(self) -> "tuple[Finding, ...]":
        """Warnings and notes of reading the files. Errors raise InputRefused when the catalogue is opened."""
        return self._composed.findings

    @property
    def digest(self) -> str:
        """SHA-256 of the content: equal for equal trees, however they are split into files."""
        return self._composed.digest

    def __len__(self) -> int:
        return len(self._composed.nodes)

    def __iter__(self) -> Iterator[Node]:
        return (Node(path, self._composed) for path in self._composed.nodes)

    def __contains__(self, path: object) -> bool:
        return path in self._composed.nodes

    def __getitem__(self, path: str) -> Node:
        """Return the node at a path; without the names of instances, the definition. Raises NotFound with near paths."""
        from sigcat.catalogue.find_node import find_node

        found = find_node(path, self._composed)
        return Node(found.node.path, found.catalogue)

    def get(self, path: str) -> Node | None:
        """Return the node at a path, or None."""
        return Node(path, self._composed) if path in self else None

    def instances(self, path: str) -> tuple[Node, ...]:
        """Return the nodes that share the definition at a path. Raises NotFound."""
        from sigcat.catalogue.find_node import find_node

        found = find_node(path, self._composed)
        return tuple(Node(node.path, self._composed) for node in found.instances or (found.node,))

    def search(
        self,
        text: str = "",
        *,
        type: str | None = None,  # noqa: A002 — the attribute of VSS is called so
        datatype: str | None = None,
        unit: str | None = None,
        category: str | None = None,
        asil: str | None = None,
        overlay: str | None = None,
        deprecated: str | None = None,
        limit: int = 50,
        each_instance: bool = False,
    ) -> tuple[Node, ...]:
        """Return nodes by words of their names, descriptions and units, or by a generated name, the best first.

        The filters are exact values; `deprecated` is yes or no. Instances of one definition are one hit, unless
        `each_instance`. Raises UsageError for a value that no node can have.
        """
        from sigcat.catalogue.search import index_of
        from sigcat.catalogue.search_filters import checked_filters

        given = {
            "type": type, "datatype": datatype, "unit": unit, "category": category, "asil": asil, "overlay": overlay,
            "deprecated": deprecated,
        }  # fmt: skip
        index = index_of(self._composed)
        filters = checked_filters(given, self._composed, index)
        found = index.search(text, filters, limit=limit, each_instance=each_instance)
        return tuple(Node(node.path, self._composed) for node in found.nodes)

    def lint(self, text: str, name: str = "text") -> "tuple[Finding, ...]":
        """Return the findings of a text: an overlay over this catalogue, another tree, or a function.yaml.

        `name` is the name of the text in findings. Rules and severities are those of the project.
        """
        from sigcat.python_api.linting import findings_of

        return findings_of(text.encode("utf-8", "surrogatepass"), name, self._composed, self._lint)

    def try_overlay(self, text: str, name: str = "overlay.vspec") -> Trial:
        """Apply an overlay that is given as text; it cannot include files."""
        from sigcat.catalogue.comparing.trial import try_overlay

        tried = try_overlay(self._composed, text.encode("utf-8", "surrogatepass"), name)
        nodes = tuple(Node(node.path, tried.catalogue) for node in tried.nodes)
        return Trial(Catalogue(tried.catalogue, self._title, self._lint), nodes, tried.findings, tried.changes)

    def diff(self, new: "Catalogue") -> "tuple[Change, ...]":
        """Return the changes from this catalogue to `new`, each with its class from breaking to text only."""
        from sigcat.catalogue.comparing.diff import compare

        return compare(self._composed, new._composed)

    def resolve(self, *files: PathLike) -> "tuple[Function, ...]":
        """Resolve function files, `function.yaml` or Function JSON; together, if one uses what another defines.

        Raises InputRefused with every finding if there are errors.
        """
        from sigcat.errors import existing_file
        from sigcat.integration.reading import read_functions
        from sigcat.python_api.function import Function

        read = read_functions([(existing_file(file).read_bytes(), str(file)) for file in files], self._composed)
        known = frozenset((*self._composed.nodes, *self._composed.interfaces))
        return tuple(
            Function(each, tuple(f for f in read.findings if f.file == each.document.name), known)
            for each in read.functions
        )

    def __repr__(self) -> str:
        return f"<sigcat.Catalogue {self.name!r}: {len(self):,} nodes>"

    def _repr_html_(self) -> str:
        from sigcat.python_api.html import catalogue_html

        return catalogue_html(self._composed, self.title)


def open_catalogue(
    tree: PathLike = "interfaces",
    *,
    overlays: Iterable[PathLike] = (),
    units: Iterable[PathLike] = (),
    quantities: Iterable[PathLike] = (),
    types: Iterable[PathLike] = (),
    include_dirs: Iterable[PathLike] = (),
) -> Catalogue:
    """Open a tree: a pulled release such as `v6.0`, what sigcat ships (`interfaces`, `vss`), a .vspec file or a folder.

    The arguments are those of `sigcat show -s TREE -l OVERLAY …`. Raises InputRefused with every finding if there are errors,
    UsageError, or NotFound with near names.
    """
    from sigcat.python_api.opening import tree_source

    return loaded(tree_source(tree, overlays, units, quantities, types, include_dirs))


def loaded(source: "Source", lint: "LintOptions | None" = None) -> Catalogue:
    """Load the catalogue of a source. Raises InputRefused with every finding if there are errors."""
    from sigcat.catalogue.hosting.source import load

    return sound(load(source), source.title, lint)


def sound(
    composed: "model.Catalogue", title: str, lint: "LintOptions | None", rejected: "tuple[Finding, ...]" = ()
) -> Catalogue:
    """Return a catalogue that has no errors. Raises InputRefused; `rejected` are findings of its files as they are now."""
    from sigcat.errors import InputRefused
    from sigcat.findings import has_errors

    findings = rejected or composed.findings
    if has_errors(findings):
        errors = sum(finding.severity == "error" for finding in findings)
        count = f"{errors} error{'s' if errors > 1 else ''}"
        raise InputRefused(f"The catalogue {composed.name!r} has {count}.", findings)
    return Catalogue(composed, title, lint)


def diff(old: PathLike, new: PathLike) -> "tuple[Change, ...]":
    """Return the changes between two trees that are named as for `sigcat diff`: `v5.0`, a folder, `git:main`, an export."""
    from sigcat.catalogue.hosting.sources import source_of_tree

    return changes_between(str(old), str(new), source_of_tree)


def changes_between(old: str, new: str, release: "Release") -> "tuple[Change, ...]":
    """Compare two sides; `release` returns the source of a name that is not a file. Raises as `read_sides` does."""
    from sigcat.catalogue.comparing.diff import compare
    from sigcat.catalogue.comparing.sides import read_sides

    before, after = read_sides(old, new, release)
    return compare(before.catalogue, after.catalogue, before.unknown | after.unknown)
