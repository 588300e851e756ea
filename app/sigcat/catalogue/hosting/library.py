"""The catalogues that one process hosts: where each comes from, and its latest good state."""

import logging
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from threading import Event, Lock, Thread
from types import TracebackType
from typing import Any, NamedTuple, Protocol, Self

from sigcat import codes
from sigcat.catalogue.hosting.file_marks import Marks, marks_of
from sigcat.catalogue.hosting.source import Source, load
from sigcat.catalogue.hosting.sources import shipped_sources
from sigcat.catalogue.hosting.vehicles import composed_vehicles
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.search import SearchIndex, index_of
from sigcat.digest import digest_of
from sigcat.errors import NotFound
from sigcat.file_kind import QUANTITY_NAMES, UNIT_NAMES
from sigcat.findings import Finding, has_errors
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.names import nearest

__all__ = ["Hosted", "Library", "Source", "Watch", "load", "shipped_sources", "tell_errors"]

_log = logging.getLogger("sigcat.hosting")


class Hosted(NamedTuple):
    """A hosted catalogue: the latest good state, and the errors of the files as they are now."""

    source: Source
    catalogue: Catalogue
    rejected: tuple[Finding, ...] = ()
    """Findings of a newer state that has errors and was therefore not taken."""
    files: frozenset[Path] = frozenset()
    """Files that were read last, for the state shown or for the one rejected."""
    marks: Marks = frozenset()
    """Marks of those files and their folders before they were read."""

    @property
    def search_index(self) -> SearchIndex:
        """The words of the catalogue."""
        return index_of(self.catalogue)

    def __reduce__(self) -> tuple[Any, ...]:
        """As another process needs it, which does not look for changed files."""
        return Hosted, self[:3]


class Library:
    """Hosted catalogues by id, in order. A catalogue is replaced whole; readers keep the one they hold."""

    def __init__(self, sources: Iterable[Source], limits: Limits = DEFAULT_LIMITS) -> None:
        self._limits = limits
        self._lock = Lock()
        self._refused: tuple[Finding, ...] = ()
        self._seen: dict[str, Marks] = {}
        self._hosted = {source.id: self._load(source) for source in sources}

    def __iter__(self) -> Iterator[Hosted]:
        return iter(tuple(self._hosted.values()))

    def __getstate__(self) -> Any:
        """As another process needs it: what is hosted at this moment."""
        return self._limits, self._hosted

    def __setstate__(self, state: Any) -> None:
        self._limits, self._hosted = state
        self._refused = ()
        self._seen = {}
        self._lock = Lock()

    @property
    def default(self) -> Hosted:
        """The first catalogue: shown when none is named. Raises NotFound without catalogues."""
        for hosted in self._hosted.values():
            return hosted
        raise NotFound("No catalogue is hosted.")

    def find(self, catalogue_id: str) -> Hosted | None:
        """The hosted catalogue with this id, if there is one."""
        return self._hosted.get(catalogue_id)

    def get(self, catalogue_id: str) -> Hosted:
        """The hosted catalogue with this id. Raises NotFound with the nearest ids."""
        hosted = self.find(catalogue_id)
        if hosted is None:
            raise NotFound(f"Unknown catalogue {catalogue_id!r}.", nearest(catalogue_id, self._hosted))
        return hosted

    def reload(self, catalogue_id: str, settled: Marks | None = None) -> Hosted:
        """Read a catalogue's files again. With errors in them, the last good state stays, and `rejected` says why.

        It stays too if they are no longer as `settled` says once they are read: someone writes them.
        """
        with self._lock:
            before = self.get(catalogue_id)
            hosted = self._reloaded(before)
            if settled is not None and _marks(before.files) != settled:
                return before
            if hosted.rejected or before.rejected or hosted.catalogue is not before.catalogue:
                _log_state(hosted)  # a folder also changes with files that are not of the catalogue
            hosted = hosted if hosted.rejected else hosted._replace(rejected=self._refused)
            self._hosted = {**self._hosted, catalogue_id: hosted}
        return hosted

    def reload_changed(self) -> tuple[str, ...]:
        """Reload every catalogue of which a file changed since it was read; their ids."""
        changed = [hosted.source.id for hosted in self if _marks(hosted.files) != hosted.marks]
        for catalogue_id in changed:
            self.reload(catalogue_id)
        return tuple(changed)

    def reload_settled(self) -> tuple[str, ...]:
        """Reload every catalogue whose changed files were the same at the look before; their ids.

        A file that has just changed may be half written, and a part of YAML is often valid.
        """
        before, self._seen = self._seen, {hosted.source.id: _marks(hosted.files) for hosted in self}
        found = ((hosted, self._seen[hosted.source.id]) for hosted in self if hosted.source.id in self._seen)
        changed = [(hosted, now) for hosted, now in found if hosted.marks != now == before.get(hosted.source.id)]
        return tuple(hosted.source.id for hosted, now in changed if self.reload(hosted.source.id, now) is not hosted)

    def host(self, sources: Iterable[Source]) -> None:
        """Host these sources in place of the ones so far; a catalogue whose source is the same stays.

        Of one whose new source has errors, the last good state stays, and `rejected` says why.
        """
        with self._lock:
            before = {hosted.source: hosted for hosted in self._hosted.values()}
            self._hosted = {source.id: before.get(source) or self._replaced(source) for source in sources}

    def refuse(self, findings: tuple[Finding, ...]) -> None:
        """Show findings of the file that names the sources with each catalogue; those from before are taken back."""
        with self._lock:
            before, self._refused = self._refused, findings
            self._hosted = {
                name: hosted._replace(rejected=findings) if hosted.rejected in ((), before) else hosted
                for name, hosted in self._hosted.items()
            }

    def _replaced(self, source: Source) -> Hosted:
        fresh, earlier = self._load(source), self._hosted.get(source.id)
        if earlier and (faults := _faults(fresh.catalogue, earlier.catalogue)):
            fresh = fresh._replace(catalogue=earlier.catalogue, rejected=faults)
        _log_state(fresh)
        return fresh

    def _load(self, source: Source) -> Hosted:
        marks = _marks(_named_files(source))
        catalogue = load(source, self._limits)
        return _with_files(_indexed(Hosted(source, catalogue)), catalogue, marks)

    def _reloaded(self, current: Hosted) -> Hosted:
        marks = _marks(current.files)
        fresh = load(current.source, self._limits)
        if faults := _faults(fresh, current.catalogue):
            return _with_files(current._replace(rejected=faults), fresh, marks)
        is_same = fresh.digest == current.catalogue.digest and _files(fresh) == _files(current.catalogue)
        if is_same and not current.source.vehicles:  # those are composed of the catalogue again when they are asked for
            return _with_files(current._replace(rejected=()), fresh, marks)
        return _with_files(_indexed(Hosted(current.source, fresh)), fresh, marks)


def _faults(fresh: Catalogue, good: Catalogue) -> tuple[Finding, ...]:
    """Return why a newer state is not taken in place of a good one; nothing if it is, or the earlier one was not good."""
    if has_errors(good.findings):
        return ()
    had_content = {name for name, digest in _files(good) if digest != _NOTHING}
    emptied = [name for name, digest in sorted(_files(fresh)) if digest == _NOTHING and name in had_content]
    empty = tuple(_EMPTIED.finding("The file is empty.", name, fix=_WRITE_AGAIN) for name in emptied)
    findings = (*empty, *(each for each in fresh.findings if not (each.rule == _EMPTIED.id and each.file in emptied)))
    return findings if has_errors(findings) else ()


_NOTHING = digest_of(b"")
_EMPTIED = codes.OVERLAY_EMPTY.graded("error")
"""A save that was interrupted leaves an empty file, which is valid."""
_WRITE_AGAIN = "Write it again, or remove it from the project file."


def _indexed(hosted: Hosted) -> Hosted:
    """The same, once its words and its digest are ready: no request waits for them."""
    index_of(hosted.catalogue)
    assert hosted.catalogue.digest
    return hosted


class Reloading(Protocol):
    """Sources that are read from files, and detect which of them changed."""

    def reload_settled(self) -> object:
        """Read what changed again, if it was the same at the look before."""
        ...


class Watch:
    """Looks for changed files while it is entered, in a separate thread, and has them read again."""

    def __init__(self, *watched: Reloading, seconds: float = 1.0) -> None:
        self._watched = watched
        self._seconds = seconds
        self._stop = Event()
        self._thread = Thread(target=self._run, name="sigcat-watch", daemon=True)

    def __enter__(self) -> Self:
        self._thread.start()
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        self._stop.set()
        self._thread.join()

    def _run(self) -> None:
        while not self._stop.wait(self._seconds):
            for each in self._watched:
                _look_at(each)


def _look_at(watched: Reloading) -> None:
    try:
        watched.reload_settled()
    except Exception:  # noqa: BLE001 - the next look may succeed, and what is hosted stays as it is
        _log.exception("files that changed could not be read again")


def tell_errors(library: Library) -> None:
    """Log the errors of catalogues that are served without an earlier valid version."""
    for hosted in library:
        errors = [finding for finding in hosted.catalogue.findings if finding.severity == "error"]
        if errors:
            _log.warning(
                "Catalogue %s has errors and no earlier valid version; it is served incomplete", hosted.source.id
            )
            log_findings(errors)
        _log_vehicles(hosted)


def _log_vehicles(hosted: Hosted) -> None:
    """Log the errors of the vehicles, which requests compose."""
    composed = composed_vehicles(hosted.catalogue, hosted.source, hosted.source.vehicles)
    for vehicle, errors in [(each.vehicle, each.errors) for each in composed if each.errors]:
        _log.warning("%s of catalogue %s has errors; it is served incomplete", vehicle.label, hosted.source.id)
        log_findings(errors)


def _log_state(hosted: Hosted) -> None:
    if not hosted.rejected:
        _log.info("%s: read again, %d nodes", hosted.source.id, len(hosted.catalogue.nodes))
        _log_vehicles(hosted)
        return
    _log.warning("%s: the files have errors; the last good state stays", hosted.source.id)
    log_findings(hosted.rejected)


def log_findings(findings: Sequence[Finding]) -> None:
    """Log findings, at most a hundred."""
    for finding in findings[:_MOST_LOGGED]:
        _log.warning("%s", finding.line_of_text)
    if len(findings) > _MOST_LOGGED:
        _log.warning("and %d more", len(findings) - _MOST_LOGGED)


_MOST_LOGGED = 100
"""Lines of the log about one state of a catalogue."""


def _with_files(hosted: Hosted, fresh: Catalogue, before: Marks) -> Hosted:
    """`hosted` with what was read for `fresh`. Marks taken before reading count: a change meanwhile is seen next."""
    files = frozenset((*_named_files(hosted.source), *(Path(name) for name, _ in _files(fresh))))
    earlier = {mark[0]: mark for mark in before}
    marks = frozenset(earlier.get(mark[0], mark) for mark in _marks(files))
    return hosted._replace(files=files, marks=marks)


def _files(catalogue: Catalogue) -> frozenset[tuple[str, str]]:
    """Names and digests of the files that were read."""
    return frozenset((file.name, file.digest) for file in catalogue.files)


def _named_files(source: Source) -> frozenset[Path]:
    """The files that a source names, and those that would be read if they stood beside its tree."""
    names = (*UNIT_NAMES, *QUANTITY_NAMES)
    beside = (path.with_name(name) for path in (source.spec, *source.overlays) for name in names)
    of_vehicles = (path for vehicle in source.vehicles for path in vehicle.overlays)
    lists = (*source.overlays, *source.units, *source.quantities, *source.types, *of_vehicles)
    return frozenset((source.spec, *lists, *beside))


def _marks(files: frozenset[Path]) -> Marks:
    """Marks of files and of their folders: a folder changes when a file that was missing appears."""
    return marks_of({*files, *(file.parent for file in files)})
