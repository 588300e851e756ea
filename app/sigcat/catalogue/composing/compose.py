"""Compose a catalogue: layers in, a frozen tree and findings out.

The steps, each in the file of its name: `merge_layers` (which checks each node with `check_definition`), `build_tree`,
`expand_instances`, and `build_tree` again to freeze the result.
"""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path

from sigcat import codes
from sigcat.catalogue.composing.build_tree import Draft, draft_tree, frozen_tree
from sigcat.catalogue.composing.expand_instances import TooManyNodes, expand_instances
from sigcat.catalogue.composing.merge_layers import merge_layers
from sigcat.catalogue.composing.older_releases import read_units, tolerant, with_present_spellings
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.circles import circles
from sigcat.catalogue.model.datatypes import element_of, is_array
from sigcat.catalogue.model.definition import STRUCT, Definition, Scope
from sigcat.catalogue.model.vocabulary import EMPTY, Vocabulary
from sigcat.catalogue.reading.layers import Layer, read_layer
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.findings import Finding, has_errors, in_order
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.names import bounded_proposals, last_name, parent_path
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
    has_standard_units: bool = True,
) -> Catalogue:
    """Read a tree from files and compose it. Units and quantities add to those beside the tree and its overlays.

    `is_release`: the tree is an official one; its own errors become warnings, as in every tree from before VSS 5.0.
    """
    with collector_paused():
        vocabulary, is_older = read_units(
            spec, units, quantities, limits, overlays=overlays, has_standard=has_standard_units
        )
        base = read_layer(spec, include_dirs, limits=limits)
        if is_older:
            base = with_present_spellings(base)
        layers = [read_layer(path, include_dirs, is_overlay=True, limits=limits) for path in overlays]
        type_layers = [read_layer(path, include_dirs, limits=limits) for path in types]
        catalogue = compose(
            [base, *layers], vocabulary, type_layers, name=name or spec.stem, expanded=expanded, limits=limits
        )
    return tolerant(catalogue) if is_older or is_release else catalogue


@bounded_proposals()
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
    """The same catalogue with its instances not expanded."""
    if not catalogue.is_expanded:
        return catalogue
    root = draft_tree(catalogue.definitions, DEFAULT_LIMITS, [])
    roots = (frozen_tree(root, []), *catalogue.roots[1:]) if root is not None else catalogue.roots
    return catalogue.with_roots(roots, is_expanded=False)


def expanded_paths(catalogue: Catalogue, limits: Limits = DEFAULT_LIMITS) -> Iterator[tuple[str, str]]:
    """Every path of the signal tree with instances expanded, with the path of its definition.

    Nothing if there is no root; unexpanded paths if there are too many instances. Quicker than composing again.
    """
    root = draft_tree(catalogue.definitions, limits, [])
    if root is None:
        return
    waiting = [(root.name, expand_or_report(root, scope_of(catalogue, limits), limits, []))]
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
    known = earlier.definitions if earlier is not None and same_scope else None
    merged = merge_layers(layers, scope, known, limits)
    findings.extend(merged.findings)
    findings.extend(missing_units(merged.definitions, vocabulary))
    of_root: list[Finding] = []
    root = draft_tree(merged.definitions, limits, of_root)
    findings.extend(() if _is_unread(layers) else of_root)
    if root is not None and expanded:
        root = expand_or_report(root, scope, limits, findings)
    roots = tuple(frozen_tree(draft, findings) for draft in (root, type_root) if draft is not None)
    every_layer = (*layers, *types)
    return Catalogue(name, roots, vocabulary, every_layer, in_order(findings), merged.definitions, expanded)


def _is_unread(layers: Sequence[Layer]) -> bool:
    """Whether the tree itself could not be read: that its overlays have no root follows from it."""
    return bool(layers) and not layers[0].statements and has_errors(layers[0].findings)


def missing_units(definitions: Mapping[str, Definition], vocabulary: Vocabulary) -> Iterator[Finding]:
    """Report that no units were read, once for all signals that have one."""
    if vocabulary.units or vocabulary.findings:
        return
    using = [definition for definition in definitions.values() if isinstance(definition.values.get("unit"), str)]
    if using:
        message = f"No units file found, but {len(using)} {'signal has' if len(using) == 1 else 'signals have'} a unit."
        fix = "Put units.yaml and quantities.yaml beside the tree, or name them with -u and -q."
        yield codes.UNITS_MISSING.finding(message, *using[0].origin("unit").position, using[0].path, fix=fix)


def expand_or_report(root: Draft, scope: Scope, limits: Limits, findings: list[Finding]) -> Draft:
    """Return the tree with instances expanded; unexpanded, and a finding, if there are too many."""
    try:
        return expand_instances(root, scope, limits)
    except TooManyNodes as error:
        definition = error.draft.definition
        message = f"The instances make {error.count:,} nodes; the limit is {limits.nodes:,}. None are expanded."
        origin = definition.origin("instances")
        findings.append(codes.INSTANCES_MULTIPLY.finding(message, *origin.position, definition.path))
        return root


def scope_of(catalogue: Catalogue, limits: Limits) -> Scope:
    """The scope in which the signals of a catalogue were defined."""
    structs = (node for root in catalogue.roots[1:] for node in root.walk() if node.type == STRUCT)
    properties = {node.path: {child.name: child.definition for child in node.children} for node in structs}
    return Scope(catalogue.vocabulary, Matching(limits.pattern_seconds), properties, _by_last_name(properties))


def _by_last_name(paths: Iterable[str]) -> Mapping[str, Sequence[str]]:
    found: dict[str, list[str]] = {}
    for path in paths:
        found.setdefault(last_name(path), []).append(path)
    return found


def _type_tree(
    types: Sequence[Layer], vocabulary: Vocabulary, limits: Limits, findings: list[Finding]
) -> tuple[Draft | None, Scope]:
    """The tree of struct types, and the scope in which signals may use them."""
    matching = Matching(limits.pattern_seconds)
    if not types:
        return None, Scope(vocabulary, matching)
    paths = merge_layers(types, Scope(vocabulary, matching), limits=limits).definitions
    structs: dict[str, dict[str, Definition]] = {path: {} for path, d in paths.items() if d.type == STRUCT}
    scope = Scope(vocabulary, matching, structs, _by_last_name(structs))
    merged = merge_layers(types, scope, limits=limits)
    for path, definition in merged.definitions.items():
        if parent_path(path) in structs:
            structs[parent_path(path)][last_name(path)] = definition
    findings.extend(merged.findings)
    findings.extend(_structs_in_themselves(structs))
    return draft_tree(merged.definitions, limits, findings), scope


def _structs_in_themselves(structs: Mapping[str, Mapping[str, Definition]]) -> Iterator[Finding]:
    """Report each circle of structs at its first property. A struct may have a list of itself: that can end."""
    members = [each for properties in structs.values() for each in properties.values() if not _is_open_list(each)]
    links: dict[str, list[str]] = {path: [] for path in structs}
    for each in members:
        links[parent_path(each.path)].append(_struct(each))
    for circle in circles(links):
        first = next(each for each in members if parent_path(each.path) in circle and _struct(each) in circle)
        struct = parent_path(first.path)
        through = "" if len(circle) == 1 else f", through {' and '.join(sorted({*circle} - {struct}))}"
        message = f"A struct must not contain itself; {struct!r} does{through}."
        fix = "Give the property another datatype, such as the number of an entry."
        yield codes.STRUCT_CONTAINS_ITSELF.finding(message, *first.origin("datatype").position, first.path, fix=fix)


def _struct(definition: Definition) -> str:
    return element_of(str(definition.values.get("datatype", "")))


def _is_open_list(definition: Definition) -> bool:
    is_list = is_array(str(definition.values.get("datatype", "")))
    return is_list and definition.values.get("arraysize") is None
