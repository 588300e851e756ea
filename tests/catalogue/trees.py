"""Small trees for the tests: text in, catalogue out."""

from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.vocabulary import EMPTY
from sigcat.catalogue.reading.layers import layer_from_text

ROOT = "Vehicle:\n  type: branch\n  description: A vehicle.\n"


def catalogue_of(text: str, *overlays: str, expanded: bool = True, earlier: Catalogue | None = None) -> Catalogue:
    """A catalogue of a tree and overlays, named `tree`, `overlay1`, `overlay2`, …"""
    layers = [layer_from_text(text.encode(), "tree", is_overlay=False)]
    layers += [layer_from_text(overlay.encode(), f"overlay{n}") for n, overlay in enumerate(overlays, 1)]
    return compose(layers, EMPTY, expanded=expanded, earlier=earlier)


def findings_of(text: str, *overlays: str) -> list[str]:
    """Codes of the findings, in the order of the text."""
    return [finding.rule for finding in catalogue_of(text, *overlays).findings]
