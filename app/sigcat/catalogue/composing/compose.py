"""Compose a catalogue: layers in, a frozen tree and findings out."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from sigcat import codes
from sigcat.catalogue.composing.instances import Draft, TooManyNodes, expand
from sigcat.catalogue.composing.merge import merge, merge_over
from sigcat.catalogue.composing.older_releases import in_present_words, read_units, tolerant
from sigcat.catalogue.composing.tree import draft_tree, frozen_tree
from sigcat.catalogue.model.catalogue import Catalogue, CataloguePart
from sigcat.catalogue.model.definition import STRUCT, Definition, Scope
from sigcat.catalogue.model.vocabulary import EMPTY, Vocabulary
from sigcat.catalogue.reading.layers import Layer, read_layer
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.findings import Finding, in_order
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.names import last_name, parent_path
from sigcat.patterns import Matching


def read_catalogue(
    spec: Path,
    overlays: Sequence[Path] = (),
    *,
    include_dirs: Sequence[Path] = (),
    units: Sequence[Path] = (),
    quantities: Sequence[Path] = (),
    types: Sequence[Path] = (),
    name: str = "",
    expanded: bool = True,
    limits: Limits = DEFAULT_LIMITS,
    is_release: bool = False,
) -> Catalogue:
    """Read a tree from files and compose it. Options have the meaning of those of `vspec export`.

    `is_release`: the tree is an official one; errors of its own are warnings, as in every tree of before VSS 5.0.
    """
    with collector_paused():
        vocabulary, is_older = read_units(spec, units, quantities, limits)
        base = read_layer(spec, include_dirs, limits=limits)
        if is_older:
            base = in_present_words(base)
        layers = [read_layer(path, include_dirs, is_overlay=True, limits=limits) for path in overlays]
        type_layers = [read_layer(path, include_dirs, limits=limits) for path in types]
        catalogue = compose(
            [base, *layers], vocabulary, type_layers, name=name or spec.stem, expanded=expanded, limits=limits
        )
    return tolerant(catalogue) if is_older or is_release else catalogue


def compose(
    layers: Sequence[Layer],
    vocabulary: Vocabulary = EMPTY,
    types: Sequence[Layer] = (),
    *,
    name: str = "",
    expanded: bool = True,
    limits: Limits = DEFAULT_LIMITS,
    earlier: Catalogue | None = None,
) -> Catalogue:
    """Compose layers, the base first, into a catalogue. Everything wrong is among its findings.

    With `earlier`, a catalogue of the same vocabulary and types, definitions that did not change are taken from it.
    """
    with collector_paused():
        return _compose(layers, vocabulary, types, name, expanded, limits, earlier)


def compose_part(base: Catalogue, overlay: Layer, limits: Limits = DEFAULT_LIMITS) -> CataloguePart:
    """What an overlay makes of a catalogue, as far as it reaches: for judging the overlay, in a fraction of the time.

    All definitions are there; nodes and findings only of those of which the overlay speaks, of what stands above them,
    and of the branches beside these. Instances are not expanded.
    """
    with collector_paused():
        changed = merge_over(base.definitions, overlay, _scope_of(base, limits), limits)
        reached = _near(base, changed.definitions)
        findings = [*overlay.findings, *changed.findings]
        root = draft_tree(reached, DEFAULT_LIMITS, findings)
        roots = (frozen_tree(root, findings),) if root is not None else ()
    return CataloguePart(base, overlay, roots, in_order(findings), changed.definitions)


def unexpanded(catalogue: Catalogue) -> Catalogue:
    """The same catalogue with instances left as they were written."""
    if not catalogue.is_expanded:
        return catalogue
    root = draft_tree(catalogue.definitions, DEFAULT_LIMITS, [])
    roots = (frozen_tree(root, []), *catalogue.roots[1:]) if root is not None else catalogue.roots
    return catalogue.with_roots(roots, is_expanded=False)


def expanded_paths(catalogue: Catalogue, limits: Limits = DEFAULT_LIMITS) -> Iterator[tuple[str, str]]:
    """Every path that the signal tree has with instances expanded, with the path of its definition.

    Nothing where there is no root; as it is written where instances are too many. Quicker than composing anew.
    """
    root = draft_tree(catalogue.definitions, limits, [])
    if root is None:
        return
    waiting = [(root.name, _expand(root, _scope_of(catalogue, limits), limits, []))]
    while waiting:
        path, draft = waiting.pop()
        if not draft.definition.values.get("delete"):
            yield path, draft.definition.path
            waiting.extend((f"{path}.{name}", child) for name, child in reversed([*draft.children.items()]))


def _compose(
    layers: Sequence[Layer],
    vocabulary: Vocabulary,
    types: Sequence[Layer],
    name: str,
    expanded: bool,
    limits: Limits,
    earlier: Catalogue | None,
) -> Catalogue:
    findings: list[Finding] = [*vocabulary.findings]
    for layer in (*layers, *types):
        findings.extend(layer.findings)
    type_root, scope = _type_tree(types, vocabulary, limits, findings)
    same_scope = earlier is not None and earlier.vocabulary is vocabulary and not types
    merged = merge(layers, scope, earlier.definitions if earlier is not None and same_scope else None, limits)
    findings.extend(merged.findings)
    root = draft_tree(merged.definitions, limits, findings)
    if root is not None and expanded:
        root = _expand(root, scope, limits, findings)
    roots = tuple(frozen_tree(draft, findings) for draft in (root, type_root) if draft is not None)
    every_layer = (*layers, *types)
    return Catalogue(name, roots, vocabulary, every_layer, in_order(findings), merged.definitions, expanded)


def _expand(root: Draft, scope: Scope, limits: Limits, findings: list[Finding]) -> Draft:
    try:
        return expand(root, scope, limits)
    except TooManyNodes as error:
        definition = error.draft.definition
        message = f"Instances make {error.count:,} nodes; the limit is {limits.nodes:,}. Nothing is expanded."
        findings.append(codes.INSTANCES_MULTIPLY.finding(message, *definition.origin("instances")[:3], definition.path))
        return root


def _near(base: Catalogue, changed: Mapping[str, Definition]) -> dict[str, Definition]:
    """What is changed and what stands above it, and branches right below these: what a misspelled one may have meant."""
    near: dict[str, Definition] = {}
    for path in _with_those_above([*(root.path for root in base.roots[:1]), *changed]):
        definition = changed.get(path) or base.definitions.get(path) or _made_branch(path, base)
        if definition is not None:
            near[path] = definition
        for branch in base.branches.get(path, ()):
            near[branch.path] = changed.get(branch.path, branch)
    near.update(_below_retyped(base, changed))
    new = {path: len(base.positions) + place for place, path in enumerate(changed)}
    return {path: near[path] for path in sorted(near, key=lambda path: base.positions.get(path, new.get(path, -1)))}


def _below_retyped(base: Catalogue, changed: Mapping[str, Definition]) -> dict[str, Definition]:
    """What stands below nodes to which an overlay gives a type: it may have no place there any more."""
    retyped = {path for path, made in changed.items() if made.origin("type").overlay and _may_have_below(path, base)}
    if not retyped:
        return {}
    below = {path: own for path, own in base.definitions.items() if not retyped.isdisjoint(_with_those_above([path]))}
    return {path: changed.get(path, own) for path, own in below.items()}


def _may_have_below(path: str, base: Catalogue) -> bool:
    node = base.nodes.get(path)
    return bool(node.children) if node is not None else path in base.definitions


def _made_branch(path: str, catalogue: Catalogue) -> Definition | None:
    """A branch that is there without a definition; that it is missing is not the fault of an overlay."""
    node = catalogue.nodes.get(path)
    is_made = node is not None and any(
        problem.rule.id == codes.BRANCH_UNDEFINED.id for problem in node.definition.problems
    )
    return node.definition if node is not None and is_made else None


def _with_those_above(paths: Iterable[str]) -> Iterable[str]:
    """The paths and those of the branches above them, each once."""
    found: dict[str, None] = {}
    for path in paths:
        above = path
        while above and above not in found:
            found[above] = None
            above = parent_path(above)
    return found


def _scope_of(catalogue: Catalogue, limits: Limits) -> Scope:
    """The scope in which the signals of a catalogue were defined."""
    structs = (node for root in catalogue.roots[1:] for node in root.walk() if node.type == STRUCT)
    properties = {node.path: {child.name: child.definition for child in node.children} for node in structs}
    return Scope(catalogue.vocabulary, Matching(limits.pattern_seconds), properties)


def _type_tree(
    types: Sequence[Layer], vocabulary: Vocabulary, limits: Limits, findings: list[Finding]
) -> tuple[Draft | None, Scope]:
    """The tree of struct types, and the scope in which signals may use them."""
    matching = Matching(limits.pattern_seconds)
    if not types:
        return None, Scope(vocabulary, matching)
    paths = merge(types, Scope(vocabulary, matching), limits=limits).definitions
    structs: dict[str, dict[str, Definition]] = {path: {} for path, d in paths.items() if d.type == STRUCT}
    merged = merge(types, Scope(vocabulary, matching, structs), limits=limits)
    for path, definition in merged.definitions.items():
        if parent_path(path) in structs:
            structs[parent_path(path)][last_name(path)] = definition
    findings.extend(merged.findings)
    scope = Scope(vocabulary, matching, structs)
    return draft_tree(merged.definitions, limits, findings), scope
