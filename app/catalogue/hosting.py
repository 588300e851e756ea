"""The catalogues that one process hosts: where each comes from, and its latest good state."""

from collections.abc import Iterable
from pathlib import Path
from threading import Lock
from typing import NamedTuple

from app.catalogue.compose import read_catalogue
from app.catalogue.limits import DEFAULT_LIMITS, Limits
from app.catalogue.model import Catalogue
from app.catalogue.search import SearchIndex
from app.data import OVERLAYS, ROOT_FILE, VSPEC
from app.errors import NotFound
from app.findings import Finding, has_errors
from app.names import nearest


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


class Hosted(NamedTuple):
    """A hosted catalogue: the latest good state, and what is wrong with the files as they are now."""

    source: Source
    catalogue: Catalogue
    index: SearchIndex
    rejected: tuple[Finding, ...] = ()
    """Findings of a newer state that has errors and was therefore not taken."""


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


class Library:
    """Hosted catalogues by id, in order. A catalogue is replaced whole; readers keep the one they hold."""

    def __init__(self, sources: Iterable[Source], limits: Limits = DEFAULT_LIMITS) -> None:
        self._limits = limits
        self._lock = Lock()
        self._hosted = {source.id: self._load(source) for source in sources}

    def __iter__(self) -> Iterable[Hosted]:
        return iter(tuple(self._hosted.values()))

    @property
    def default(self) -> Hosted:
        """The first catalogue: the one shown when none is named."""
        return next(iter(self._hosted.values()))

    def get(self, catalogue_id: str) -> Hosted:
        """The hosted catalogue with this id. Raises NotFound with the nearest ids."""
        hosted = self._hosted.get(catalogue_id)
        if hosted is None:
            raise NotFound(f"There is no catalogue {catalogue_id!r}.", nearest(catalogue_id, self._hosted))
        return hosted

    def reload(self, catalogue_id: str) -> Hosted:
        """Read a catalogue's files again. With errors in them, the last good state stays, and `rejected` says why."""
        with self._lock:
            current = self.get(catalogue_id)
            fresh = load(current.source, self._limits)
            if has_errors(fresh.findings):
                hosted = current._replace(rejected=fresh.findings)
            else:
                hosted = Hosted(current.source, fresh, SearchIndex(fresh))
            self._hosted = {**self._hosted, catalogue_id: hosted}
            return hosted

    def _load(self, source: Source) -> Hosted:
        catalogue = load(source, self._limits)
        return Hosted(source, catalogue, SearchIndex(catalogue))
