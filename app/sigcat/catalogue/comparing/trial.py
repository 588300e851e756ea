"""Try an overlay on a catalogue before anything is stored: its changes and its errors."""

from typing import NamedTuple

from sigcat import codes
from sigcat.catalogue.comparing.changes import Change
from sigcat.catalogue.comparing.diff import compare
from sigcat.catalogue.composing.add_overlays import with_overlays
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.reading.layers import Layer, layer_from_text
from sigcat.findings import Finding
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.names import did_you_mean


class Trial(NamedTuple):
    """Effects of an overlay."""

    catalogue: Catalogue
    nodes: tuple[Node, ...]
    """Nodes that would be new or have other attributes, as they would be."""
    findings: tuple[Finding, ...]
    """Findings that the overlay adds to those of the catalogue."""
    changes: tuple[Change, ...]


class OverlayPlace(NamedTuple):
    """The place of an overlay in a catalogue."""

    base: Catalogue
    """The catalogue below it."""
    above: tuple[Layer, ...] = ()
    """Overlays that apply after it."""


def try_overlay(base: Catalogue, overlay_text: bytes, name: str, limits: Limits = DEFAULT_LIMITS) -> Trial:
    """Apply an overlay given as text, which cannot include files. Nothing is stored, and `base` stays as it is."""
    return try_layer(OverlayPlace(base), layer_from_text(overlay_text, name, limits=limits), limits)


def try_layer(place: OverlayPlace, overlay: Layer, limits: Limits = DEFAULT_LIMITS) -> Trial:
    """Apply an overlay that has been read at its place, below others that may need it.

    Errors of these others are findings of the trial.
    """
    base, above = place
    before = with_overlays(base, above, limits)
    catalogue = with_overlays(base, (overlay, *above), limits)
    known = frozenset(base.findings) | {each for each in before.findings if each.severity != "error"}
    findings = tuple(_with_near_path(finding, before) for finding in catalogue.findings if finding not in known)
    is_needed = any(each.severity == "error" and each not in base.findings for each in before.findings)
    left, right = (base, with_overlays(base, (overlay,), limits)) if is_needed else (before, catalogue)
    nodes = tuple(node for path, node in right.nodes.items() if _is_changed(left.nodes.get(path), node))
    return Trial(catalogue, nodes, findings, compare(left, right))


def _with_near_path(finding: Finding, base: Catalogue) -> Finding:
    """A node without a type that the base does not have is more often misspelled than new."""
    if finding.rule != codes.TYPE_MISSING_OR_UNKNOWN.id or finding.path in base.definitions:
        return finding
    near = did_you_mean(finding.path, base.nodes)
    return finding._replace(fix=f"{near} {finding.fix}") if near else finding


def _is_changed(before: Node | None, after: Node) -> bool:
    return before is None or (before.definition is not after.definition and before.values != after.values)
