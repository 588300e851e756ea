"""Proposals of signals that a name in code means."""

from functools import cached_property

from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.near_signals import NearSignals, is_to_be_chosen
from sigcat.names import either, last_name, may_compare


class MeantSignals:
    """Proposals for unknown paths: words are looked up in the whole catalogue."""

    def __init__(self, catalogue: Catalogue) -> None:
        self._catalogue = catalogue

    def __call__(self, path: str) -> str:
        """A sentence that proposes the signals with the words of the last name; of a path to be chosen, the nearest."""
        near = self._near.near(last_name(path)) if may_compare(len(self._catalogue.nodes)) else ()
        meant = [
            one.node.path
            for one in near
            if (is_to_be_chosen(path) and one.shares_word) or (one.has_all and one.wanted > 1 and one.whole > 1)
        ]
        return f"Did you mean {either(map(repr, meant))}?" if meant else ""

    @cached_property
    def _near(self) -> NearSignals:
        return NearSignals(self._catalogue)
