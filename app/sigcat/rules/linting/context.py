"""The context of a linted file: its tree, units, struct types, and the overlays that it stacks with."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from functools import partial
from pathlib import Path

from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.composing.older_releases import Units, read_units, with_present_spellings
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.definition import Definition
from sigcat.catalogue.model.vocabulary import Vocabulary, files_beside, read_vocabulary
from sigcat.catalogue.reading.layers import Layer, read_layer
from sigcat.data import OVERLAYS, ROOT_FILE
from sigcat.file_kind import SHIPPED_ROOT, UNIT_NAMES, root_name
from sigcat.findings import in_order
from sigcat.real_path import real_path
from sigcat.rules.linting.discovery import Source
from sigcat.rules.linting.includes import first_bytes
from sigcat.rules.linting.nearby_trees import default_tree, has_root, tree_with_root, types_beside
from sigcat.rules.linting.options import LintOptions, identity_of
from sigcat.rules.tree import Tree


def compose_tree(root: Path, options: LintOptions) -> Catalogue:
    """A whole tree with its units and struct types."""
    tree = read_layer(root, options.include_dirs)
    vocabulary, is_older = units_of(root, tree, (), options)
    types = type_layers((root,), options)
    layers = [with_present_spellings(tree) if is_older else tree]
    catalogue = compose(layers, vocabulary, types, expanded=False, name=root.stem)
    expanded = partial(compose, layers, vocabulary, types, name=root.stem, earlier=catalogue)
    return with_instances(catalogue, catalogue.definitions.values(), expanded)


def unchecked_tree(tree: Layer, vocabulary: Vocabulary) -> Catalogue:
    """The tree as it is written, unchecked: nodes that no overlay mentions are looked up, and never checked."""
    definitions = {s.path: Definition(s.path, (s,), s.values) for s in tree.statements}
    return Catalogue(tree.name, (), vocabulary, (), (), definitions, is_expanded=False)


def with_instances(catalogue: Catalogue, judged: Iterable[Definition], expanded: Callable[[], Catalogue]) -> Catalogue:
    """The catalogue with the findings of `expanded`, where checked definitions make or refine instances.

    Statements for one instance are not checked by themselves: only `expanded` has all of it.
    """
    tree = Tree(catalogue)
    if not any("instances" in definition.values or tree.is_instance(definition.path) for definition in judged):
        return catalogue
    kept = [finding for finding in catalogue.findings if tree.resolve_other(finding.path) is None]
    known = {identity_of(finding) for finding in kept}
    more = [finding for finding in expanded().findings if identity_of(finding) not in known]
    return catalogue.with_findings(in_order([*kept, *more]))


def units_of(root: Path, tree: Layer, overlays: Sequence[Path], options: LintOptions) -> Units:
    """Units beside the tree, then those beside its overlays, then those of the options; of a release of any age.

    Without any, an official tree that uses units is one of 3.0; the age of one that uses none does not matter.
    """
    units = options.units
    if overlays and root == ROOT_FILE and options.base is None:
        units = (OVERLAYS / UNIT_NAMES[0], *units)  # the shipped tree has them for functions, too
    has_any = units or files_beside((root, *overlays), UNIT_NAMES)
    if not has_any and not any("unit" in statement.values for statement in tree.statements):
        return Units(read_vocabulary((), options.quantities), is_older=False)
    return read_units(root, units, options.quantities, overlays=overlays, has_standard=options.has_standard_units)


def base_of(overlay: Path, roots: Sequence[Path], options: LintOptions) -> Path:
    """The tree below an overlay: the one of the options, the only one that is linted, one near it, or the shipped one.

    One whose root has another name than the paths of the overlay is not meant.
    """
    if options.base is not None:
        return options.base
    name = root_name(first_bytes(overlay))
    fitting = [root for root in roots if not name or has_root(root, name)]
    if len(fitting) == 1:
        return fitting[0]
    return tree_near(name, overlay) or ROOT_FILE


def tree_near(name: str, overlay: Path) -> Path | None:
    """The tree near an overlay for which one whose root is called `name` is made; None where there is only the shipped one."""
    near = default_tree(overlay)
    if near is not None and (not name or has_root(near, name)):
        return near
    return (tree_with_root(name, overlay) if name != SHIPPED_ROOT else None) or near


def stacks_of(group: Sequence[Path], options: LintOptions) -> Iterator[tuple[Path, ...]]:
    """The overlays of a group as they are checked: those of the declared stack together, each other one on top of it.

    Without a stack, overlays are alternatives: each is checked over the tree alone.
    """
    stack = {real_path(path): path for path in options.overlays}
    named = {real_path(path): path for path in group}
    stacked = tuple(named.get(real, path) for real, path in stack.items())
    if any(real in stack for real in named):
        yield stacked
    for real, path in named.items():
        if real not in stack:
            yield (*stacked, path)


def type_files(sources: Iterable[Source], options: LintOptions) -> tuple[Path, ...]:
    """The files of struct types: those of the options, and the only one that was found; of several, each has its tree."""
    known = {real_path(path): path for path in options.types}
    found = {real_path(source.path): source.path for source in sources if source.kind == "types"}
    return tuple({**known, **(found if len(found) == 1 else {})}.values())


def type_layers(files: Iterable[Path], options: LintOptions) -> list[Layer]:
    """The struct types of a tree and its overlays: those of the options, and those in the same folders."""
    paths = {real_path(path): path for path in (*types_beside(files), *options.types)}
    return [read_layer(path, options.include_dirs) for path in paths.values()]
