"""Catalogues that tests composed last, so that the next test with the same files need not compose them again.

The product composes what is in use once. A test ends before the next one begins, so nothing would be in use.
"""

from typing import Any

from sigcat.catalogue.composing import compose
from sigcat.catalogue.model.catalogue import Catalogue

MOST = 12


class _Recent(dict[tuple[Any, ...], Catalogue]):
    def __setitem__(self, composed_from: tuple[Any, ...], catalogue: Catalogue) -> None:
        while len(self) >= MOST:
            del self[next(iter(self))]
        super().__setitem__(composed_from, catalogue)


def keep() -> None:
    """Keep them from now on."""
    compose._IN_USE = _Recent()
