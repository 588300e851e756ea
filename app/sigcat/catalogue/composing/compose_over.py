"""Compose one more layer over a catalogue: what it does not reach is shared, so that many vehicles take little."""

from collections.abc import Iterable, Mapping, Sequence

from sigcat.catalogue.composing.add_overlays import with_overlays
from sigcat.catalogue.composing.build_tree import draft_tree, frozen_tree
from sigcat.catalogue.composing.compose import expand_or_report, scope_of
from sigcat.catalogue.composing.merge_layers import merge_over
from sigcat.catalogue.model.catalogue import Catalogue, Node, over
from sigcat.catalogue.model.definition import Definition, instances_of
from sigcat.catalogue.reading.layers import Layer
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.findings import in_order
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.names import parent_path

Known = dict[tuple[object, ...], Node]
"""Nodes that several catalogues share, by what they are made of. A path alone has a node whose text of the path is shared."""


def compose_over(
    base: Catalogue, layer: Layer, limits: Limits = DEFAULT_LIMITS, known: Known | None = None
) -> Catalogue:
    """Return the catalogue with the layer on top: equal to `with_overlays`, but it shares the nodes that stay.

    `known` has nodes of other catalogues over the same base, and gets those of this one.
    """
    if not _can_share(base):
        return with_overlays(base, [layer], limits)
    with collector_paused():
        return _composed(base, layer, limits, {} if known is None else known)


def _can_share(base: Catalogue) -> bool:
    """Whether all nodes are as they are written: findings in them have to be found again."""
    is_sound = not any(finding.path in base.definitions for finding in base.findings)
    return bool(base.roots) and base.is_expanded and bool(base.vocabulary.units) and is_sound


def _composed(base: Catalogue, layer: Layer, limits: Limits, known: Known) -> Catalogue:
    scope = scope_of(base, limits)
    merged = merge_over(base.definitions, layer, scope, limits)
    definitions = over(base.definitions, merged.definitions)
    tops = _tops(merged.definitions, definitions)
    if tops is None:
        return with_overlays(base, [layer], limits)
    findings = [*base.findings, *layer.findings, *merged.findings]
    root = draft_tree(_reached(definitions, tops), limits, findings)
    if root is None:
        return with_overlays(base, [layer], limits)
    part = _shared(frozen_tree(expand_or_report(root, scope, limits, findings), findings), known)
    roots = (_grafted(base.roots[0], part, frozenset(tops)), *base.roots[1:])
    return Catalogue(
        base.name, roots, base.vocabulary, _layers(base, layer), in_order(findings), definitions, is_expanded=True
    )


def _layers(base: Catalogue, layer: Layer) -> tuple[Layer, ...]:
    return (*base.tree_layers, layer, *base.type_layers)


def _tops(changed: Mapping[str, Definition], definitions: Mapping[str, Definition]) -> Sequence[str] | None:
    """Return the uppermost nodes of which something is new; None if they cannot be placed without the whole tree."""
    tops: dict[str, None] = {}
    for path in changed:
        top = path
        for above in _above(path):
            definition = definitions.get(above)
            if definition is not None and (above in changed or instances_of(definition.values)):
                top = above
        tops[top] = None
    is_placed = all(_is_placed(definitions.get(above)) for top in tops for above in _above(top))
    return list(tops) if is_placed else None


def _is_placed(definition: Definition | None) -> bool:
    """Whether a node is where its path is: some instances are beside their branch."""
    return definition is not None and definition.values.get("instances_relation") != "sibling"


def _above(path: str) -> Iterable[str]:
    """The path and those of the branches above it."""
    while path:
        yield path
        path = parent_path(path)


def _reached(definitions: Mapping[str, Definition], tops: Sequence[str]) -> Mapping[str, Definition]:
    """Return the definitions of the nodes that are made again, and of all branches above them."""
    spine = {above for top in tops for above in _above(top)}
    below = tuple(f"{top}." for top in tops)
    return {path: each for path, each in definitions.items() if path in spine or path.startswith(below)}


def _grafted(old: Node, new: Node, tops: frozenset[str]) -> Node:
    """Return the old tree with the nodes that were made again in their places."""
    if new.path in tops:
        return new
    again = {child.path: child for child in new.children}
    children = [
        _grafted(child, again.pop(child.path), tops) if child.path in again else child
        for child in old.children
        if child.path in again or child.path not in tops
    ]
    return Node(old.path, old.definition, (*children, *again.values()))


def shared_nodes(catalogue: Catalogue) -> Known:
    """Return the nodes of a catalogue, for those that are composed over it."""
    known: Known = {}
    for root in catalogue.roots[:1]:
        for node in root.walk():
            known[_made_of(node)] = known[(node.path,)] = node
    return known


def _shared(node: Node, known: Known) -> Node:
    """Return the node that is known already and made of the same, or this one, which is known from now on."""
    children = tuple(_shared(child, known) for child in node.children)
    unique = Node(known.setdefault((node.path,), node).path, node.definition, children)
    return known.setdefault(_made_of(unique), unique)


def _made_of(node: Node) -> tuple[object, ...]:
    """Return what makes two nodes over the same base equal: statements and nodes, which are held as long as the node."""
    definition = node.definition
    statements = map(id, definition.statements)
    return (node.path, definition.path, definition.is_instance, *statements, 0, *map(id, node.children))
