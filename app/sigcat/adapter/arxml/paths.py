"""Paths of elements in the packages."""

from typing import NamedTuple


class Paths(NamedTuple):
    """Paths below the outermost package."""

    root: str

    def of(self, package: str, *names: str) -> str:
        """Path of an element, or of one inside it."""
        return "/" + "/".join((self.root, package, *names))


COMPU_METHODS = "CompuMethods"
UNITS = "Units"
DIMENSIONS = "PhysicalDimensions"
CONSTRAINTS = "DataConstraints"
