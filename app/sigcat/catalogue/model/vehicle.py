"""A vehicle: the configuration for which a catalogue is composed."""

from pathlib import Path
from typing import Any, NamedTuple

VEHICLE = "vehicle:"
"""Beginning of the name of a vehicle, where a tree is named."""


class Setting(NamedTuple):
    """A path or a pattern that a vehicle names, its value, and the place in the project file."""

    path: str
    value: Any
    """Hashable: lists are tuples."""
    line: int
    column: int


class Vehicle(NamedTuple):
    """A vehicle in one of its states."""

    id: str
    title: str
    catalogue: str
    """Id of the catalogue that it is composed of."""
    file: str
    """The project file."""
    line: int
    state: str = ""
    """Empty for a vehicle that has no states."""
    labels: tuple[tuple[str, str], ...] = ()
    """Facts such as `steering` and `year`, which no node has."""
    instances: tuple[Setting, ...] = ()
    defaults: tuple[Setting, ...] = ()
    """Values of attributes of the tree."""
    without: tuple[Setting, ...] = ()
    overlays: tuple[Path, ...] = ()

    @property
    def name(self) -> str:
        """`ID`, or `ID@STATE`."""
        return f"{self.id}@{self.state}" if self.state else self.id

    @property
    def shown(self) -> str:
        """Title and state."""
        return f"{self.title}, {self.state}" if self.state else self.title

    @property
    def label(self) -> str:
        """Name of the vehicle as that of an overlay."""
        return VEHICLE + self.name
