"""Add overlays to a composed catalogue; what they do not change is taken over."""

from collections.abc import Sequence

from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.reading.layers import Layer
from sigcat.findings import Finding
from sigcat.limits import DEFAULT_LIMITS, Limits


def with_overlays(base: Catalogue, overlays: Sequence[Layer], limits: Limits = DEFAULT_LIMITS) -> Catalogue:
    """The catalogue with more overlays on top."""
    if not overlays:
        return base
    catalogue = compose(
        [*base.tree_layers, *overlays],
        base.vocabulary,
        base.type_layers,
        name=base.name,
        expanded=base.is_expanded,
        limits=limits,
        earlier=base,
    )
    return tolerating(catalogue, base.findings)


def tolerating(catalogue: Catalogue, known: Sequence[Finding]) -> Catalogue:
    """The catalogue with the warnings of the base kept as warnings, as in old releases, where composing made them errors."""
    milder = {finding._replace(severity="error"): finding for finding in known if finding.severity != "error"}
    findings = tuple(milder.get(finding, finding) for finding in catalogue.findings)
    return catalogue if findings == catalogue.findings else catalogue.with_findings(findings)
