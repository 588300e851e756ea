"""Compose a part: what an overlay makes of a catalogue, as far as it reaches, in a fraction of the time."""

from collections.abc import Iterable, Mapping

from sigcat.catalogue.composing.build_tree import draft_tree, frozen_tree
from sigcat.catalogue.composing.compose import missing_units, scope_of
from sigcat.catalogue.composing.merge_layers import merge_over
from sigcat.catalogue.model.catalogue import Catalogue, CataloguePart
from sigcat.catalogue.model.definition import Definition
from sigcat.catalogue.reading.layers import Layer
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.findings import in_order
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.names import parent_path


def compose_part(base: Catalogue, overlay: Layer, limits: Limits = DEFAULT_LIMITS) -> CataloguePart:
    """A catalogue with an overlay on top, with what is needed to check the overlay.

    It has all definitions; nodes and findings are limited to those that the overlay is about, those above them, and the
    branches beside these. Instances are not expanded.
    """
    with collector_paused():
        changed = merge_over(base.definitions, overlay, scope_of(base, limits), limits)
        reached = _near(base, changed.definitions)
        findings = [*overlay.findings, *changed.findings]
        if not base.vocabulary.units:
            findings.extend(missing_units({**base.definitions, **changed.definitions}, base.vocabulary))
        root = draft_tree(reached, DEFAULT_LIMITS, findings)
        roots = (frozen_tree(root, findings),) if root is not None else ()
    return CataloguePart(base, overlay, roots, in_order(findings), changed.definitions)


def _near(base: Catalogue, changed: Mapping[str, Definition]) -> dict[str, Definition]:
    """Changed definitions, all above them, and the branches right below these, which a misspelled path may have meant.

    A branch that the base does not define is added again for the definition of the base that it was added for.
    """
    near: dict[str, Definition] = {}
    for path in _with_ancestors([*(root.path for root in base.roots[:1]), *changed]):
        definition = changed.get(path) or base.definitions.get(path) or base.first_below.get(path)
        if definition is not None:
            near[definition.path] = changed.get(definition.path, definition)
        for branch in base.branches.get(path, ()):
            near[branch.path] = changed.get(branch.path, branch)
    near.update(_below_retyped(base, changed))
    new = {path: len(base.positions) + number for number, path in enumerate(changed)}
    return {path: near[path] for path in sorted(near, key=lambda path: base.positions.get(path, new.get(path, -1)))}


def _below_retyped(base: Catalogue, changed: Mapping[str, Definition]) -> dict[str, Definition]:
    """Return the nodes below one to which an overlay gives a type that must not have them."""
    retyped = {path for path, new in changed.items() if new.origin("type").overlay and path in base.first_below}
    if not retyped:
        return {}
    below = {path: own for path, own in base.definitions.items() if not retyped.isdisjoint(_with_ancestors([path]))}
    return {path: changed.get(path, own) for path, own in below.items()}


def _with_ancestors(paths: Iterable[str]) -> Iterable[str]:
    """The paths and those of all branches above them, each once."""
    found: dict[str, None] = {}
    for path in paths:
        above = path
        while above and above not in found:
            found[above] = None
            above = parent_path(above)
    return found
