"""Source of one catalogue: a tree, its overlays in order, and its vocabulary."""

from pathlib import Path
from typing import NamedTuple

from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.limits import DEFAULT_LIMITS, Limits


class Source(NamedTuple):
    """Source of a catalogue: a tree, its overlays in order, and its vocabulary."""

    id: str
    """Name in addresses and on the command line."""
    title: str
    spec: Path
    overlays: tuple[Path, ...] = ()
    units: tuple[Path, ...] = ()
    quantities: tuple[Path, ...] = ()
    types: tuple[Path, ...] = ()
    include_dirs: tuple[Path, ...] = ()
    release: str = ""
    """Name of the official release that the tree is; its own errors are warnings. Empty: the user's own tree."""
    has_standard_units: bool = True
    """Whether a tree without a file of units has those of VSS, and units may measure the quantities of VSS."""


def load(source: Source, limits: Limits = DEFAULT_LIMITS, *, expanded: bool = True) -> Catalogue:
    """Read and compose the catalogue of a source, of whatever release it is."""
    return read_catalogue(
        source.spec,
        source.overlays,
        include_dirs=source.include_dirs,
        units=source.units,
        quantities=source.quantities,
        types=source.types,
        expanded=expanded,
        name=source.id,
        limits=limits,
        is_release=bool(source.release),
        has_standard_units=source.has_standard_units,
    )
