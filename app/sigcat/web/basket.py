"""The basket: paths that a user chose. It is a parameter of the address and nothing else, so that every link to a page keeps it."""

from collections.abc import Iterable
from typing import NamedTuple

from sigcat.errors import UsageError
from sigcat.limits import BASKET_CHARACTERS

PICK = "pick"
"""Parameter that every page takes."""


class Basket(NamedTuple):
    """Paths in the order in which they were chosen, each once. The path of a branch adds all signals below it."""

    paths: tuple[str, ...] = ()

    @property
    def text(self) -> str:
        """Value of the parameter."""
        return ",".join(self.paths)

    def toggled(self, path: str) -> "Basket":
        """With a path that it does not have, or without one that it has."""
        if path in self.paths:
            return Basket(tuple(each for each in self.paths if each != path))
        return Basket((*self.paths, path))

    def with_all(self, paths: Iterable[str]) -> "Basket":
        """With further paths."""
        return Basket(tuple(dict.fromkeys((*self.paths, *paths))))


EMPTY = Basket()


def read_basket(text: str) -> Basket:
    """The basket of a parameter, or of pasted text with paths in lines. Raises UsageError if it is too long for an address."""
    if len(text) > BASKET_CHARACTERS:
        raise UsageError(
            f"The paths of a basket must have at most {BASKET_CHARACTERS:,} characters. Choose branches instead."
        )
    return EMPTY.with_all(text.replace(",", " ").replace(";", " ").replace("/", ".").split())
