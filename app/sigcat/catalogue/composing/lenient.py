"""A tree as leniently as vss-tools reads it, for those who have to export what they cannot change."""

from sigcat import codes
from sigcat.catalogue.model.catalogue import Catalogue

_TAKEN = frozenset((codes.DUPLICATE_KEY.id,))
"""Errors in a text that vss-tools 6.1 reads without a word. Composing reads it the same way: the last one counts."""


def as_vss_tools_takes_it(catalogue: Catalogue) -> Catalogue:
    """The catalogue with a warning in place of each error that vss-tools does not make."""
    return catalogue.with_findings(
        tuple(each._replace(severity="warning") if each.rule in _TAKEN else each for each in catalogue.findings)
    )
