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


def try_overlay(base: Catalogue, overlay_text: bytes, name: str, limits: Limits = DEFAULT_LIMITS) -> Trial:
    """Apply an overlay given as text, which cannot include files. Nothing is stored, and `base` stays as it is."""
    return try_layer(base, layer_from_text(overlay_text, name, limits=limits), limits)


def try_layer(base: Catalogue, overlay: Layer, limits: Limits = DEFAULT_LIMITS) -> Trial:
    """Apply an overlay that has been read."""
    catalogue = with_overlays(base, (overlay,), limits)
    nodes = tuple(node for path, node in catalogue.nodes.items() if _is_changed(base.nodes.get(path), node))
    known = frozenset(base.findings)
    findings = tuple(_with_near_path(finding, base) for finding in catalogue.findings if finding not in known)
    return Trial(catalogue, nodes, findings, compare(base, catalogue))


def _with_near_path(finding: Finding, base: Catalogue) -> Finding:
    """A node without a type that the base does not have is more often misspelled than new."""
    if finding.rule != codes.TYPE_MISSING_OR_UNKNOWN.id or finding.path in base.definitions:
        return finding
    near = did_you_mean(finding.path, base.nodes)
    return finding._replace(fix=f"{near} {finding.fix}") if near else finding


def _is_changed(before: Node | None, after: Node) -> bool:
    return before is None or (before.definition is not after.definition and before.values != after.values)
