"""Compose a catalogue: layers in, a frozen tree and findings out."""

from collections.abc import Sequence
from pathlib import Path

from app.catalogue.definition import STRUCT, Definition, Scope
from app.catalogue.instances import Draft, TooManyNodes, expand
from app.catalogue.layers import Layer, read_layer
from app.catalogue.limits import DEFAULT_LIMITS, Limits
from app.catalogue.merge import merge
from app.catalogue.model import Catalogue
from app.catalogue.quirks import in_present_words, read_units, tolerant
from app.catalogue.tree import draft_tree, frozen_tree
from app.catalogue.vocabulary import EMPTY, Vocabulary
from app.catalogue.yaml_document import collector_paused
from app.findings import Finding, in_order
from app.names import last_name, parent_path


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


def unexpanded(catalogue: Catalogue) -> Catalogue:
    """The same catalogue with instances left as they were written."""
    if not catalogue.is_expanded:
        return catalogue
    root = draft_tree(catalogue.definitions, DEFAULT_LIMITS, [])
    roots = (frozen_tree(root, []), *catalogue.roots[1:]) if root is not None else catalogue.roots
    return Catalogue(
        catalogue.name, roots, catalogue.vocabulary, catalogue.layers, catalogue.findings, catalogue.definitions, False
    )


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
    merged = merge(layers, scope, earlier.definitions if earlier is not None and same_scope else None)
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
        findings.append(Finding("V025", "error", message, *definition.origin("instances")[:3], definition.path))
        return root


def _type_tree(
    types: Sequence[Layer], vocabulary: Vocabulary, limits: Limits, findings: list[Finding]
) -> tuple[Draft | None, Scope]:
    """The tree of struct types, and the scope in which signals may use them."""
    if not types:
        return None, Scope(vocabulary)
    paths = merge(types, Scope(vocabulary)).definitions
    structs: dict[str, dict[str, Definition]] = {path: {} for path, d in paths.items() if d.type == STRUCT}
    merged = merge(types, Scope(vocabulary, structs))
    for path, definition in merged.definitions.items():
        if parent_path(path) in structs:
            structs[parent_path(path)][last_name(path)] = definition
    findings.extend(merged.findings)
    scope = Scope(vocabulary, structs)
    return draft_tree(merged.definitions, limits, findings), scope
