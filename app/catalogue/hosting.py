"""The catalogues that one process hosts: where each comes from, and its latest good state."""

from collections.abc import Iterable, Iterator
from threading import Lock
from typing import NamedTuple

from app.catalogue.limits import DEFAULT_LIMITS, Limits
from app.catalogue.model import Catalogue
from app.catalogue.search import SearchIndex
from app.catalogue.sources import Source, load, shipped_sources
from app.errors import NotFound
from app.findings import Finding, has_errors
from app.names import nearest

__all__ = ["Hosted", "Library", "Source", "load", "shipped_sources"]


class Hosted(NamedTuple):
    """A hosted catalogue: the latest good state, and what is wrong with the files as they are now."""

    source: Source
    catalogue: Catalogue
    search_index: SearchIndex
    rejected: tuple[Finding, ...] = ()
    """Findings of a newer state that has errors and was therefore not taken."""


class Library:
    """Hosted catalogues by id, in order. A catalogue is replaced whole; readers keep the one they hold."""

    def __init__(self, sources: Iterable[Source], limits: Limits = DEFAULT_LIMITS) -> None:
        self._limits = limits
        self._lock = Lock()
        self._hosted = {source.id: self._load(source) for source in sources}

    def __iter__(self) -> Iterator[Hosted]:
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
