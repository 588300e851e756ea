"""Where catalogues come from: the trees that sigcat ships, and any other tree with its overlays."""

from pathlib import Path
from typing import NamedTuple

from app.catalogue.compose import read_catalogue
from app.catalogue.limits import DEFAULT_LIMITS, Limits
from app.catalogue.model import Catalogue
from app.data import OVERLAYS, ROOT_FILE, VSPEC


class Source(NamedTuple):
    """Where a catalogue comes from: a tree, its overlays in order, and its vocabulary."""

    id: str
    """Name in addresses and on the command line."""
    title: str
    spec: Path
    overlays: tuple[Path, ...] = ()
    units: tuple[Path, ...] = ()
    quantities: tuple[Path, ...] = ()
    types: tuple[Path, ...] = ()
    include_dirs: tuple[Path, ...] = ()


SHIPPED_UNITS = (VSPEC / "units.yaml", OVERLAYS / "units.yaml")


def shipped_sources() -> tuple[Source, ...]:
    """The trees that sigcat ships: the standard tree alone, and with the interface overlays."""
    units = tuple(path for path in SHIPPED_UNITS if path.is_file())
    overlays = tuple(
        OVERLAYS / f"{name}.vspec" for name in ("ecocontrol", "error", "safety_reaction", "mode", "scheduling")
    )
    return (
        Source("interfaces", "VSS 6.0 with function interfaces", ROOT_FILE, overlays, units),
        Source("vss", "VSS 6.0", ROOT_FILE),
    )


def load(source: Source, limits: Limits = DEFAULT_LIMITS) -> Catalogue:
    """Read and compose the catalogue of a source."""
    return read_catalogue(
        source.spec,
        source.overlays,
        include_dirs=source.include_dirs,
        units=source.units,
        quantities=source.quantities,
        types=source.types,
        name=source.id,
        limits=limits,
    )
