"""The functions that a service hosts, and their runs: those that sigcat ships, and those in folders that its configuration names."""

import logging
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from threading import Lock
from typing import NamedTuple, TypeVar

from sigcat.catalogue.hosting.file_marks import Marks, marks_of
from sigcat.catalogue.hosting.library import Hosted, log_findings
from sigcat.catalogue.hosting.variants import expanded_of
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.interfaces import FUNCTION_BRANCH
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.data import EXAMPLES
from sigcat.digest import digest_of
from sigcat.errors import NotFound
from sigcat.findings import Finding
from sigcat.function.function_file import CheckedFunction, FunctionFile, check_files, read_function_file
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.hosted_comparisons import FILE as COMPARISON_FILE
from sigcat.function.hosted_comparisons import HostedComparisons, comparisons_among, told_apart
from sigcat.function.hosted_files import SHIPPED, HostedFile, HostedFiles, candidates, files_in, shipped_files, with_ids
from sigcat.function.hosted_runs import ENDING as RUN_ENDING
from sigcat.function.hosted_runs import HostedRuns, recordings_among, runs_of
from sigcat.function.last_good import Faults, with_last_good
from sigcat.names import nearest

Found = TypeVar("Found")
_log = logging.getLogger("sigcat.hosting")


class HostedFunction(NamedTuple):
    """A function file over a catalogue. `resolved` is None if it does not fit the catalogue."""

    file: HostedFile
    resolved: ResolvedFunction | None
    findings: tuple[Finding, ...]

    @property
    def id(self) -> str:
        """Name in addresses."""
        return self.file.id

    @property
    def function(self) -> FunctionJson | None:
        """The function as it is written."""
        return self.resolved.function if self.resolved else None

    @property
    def name(self) -> str:
        """Name of the function; its id if it could not be built."""
        return self.function.info.function_name if self.function else self.id


class FunctionLibrary:
    """The function files of a service. They are replaced as a whole; readers keep those that they hold."""

    def __init__(
        self, folders: Iterable[Path] = (), *, has_shipped: bool = True, catalogues: Iterable[Hosted] = ()
    ) -> None:
        self._catalogues = catalogues
        self.folders = tuple(folders)
        self._has_shipped = has_shipped
        self._lock = Lock()
        self.files: HostedFiles = ()
        self.skipped: tuple[str, ...] = ()
        """Names of files that are too large."""
        self.recordings: HostedRuns = ()
        self.comparisons: HostedComparisons = ()
        self._marks: Marks = frozenset()
        self._seen: Marks = frozenset()
        self.reload()

    @property
    def digest(self) -> str:
        """SHA-256 of the files: it differs as soon as one of them does."""
        return _digest(self.files)

    def reload(self) -> HostedFiles:
        """Read the files again. Of one that broke the last good state stays, and `rejected` says why."""
        with self._lock:
            self._marks = self._marked()
            before = tuple(file for file in self.files if not file.is_shipped)
            own = tuple(file for folder in self.folders for file in files_in(folder, before))
            self.skipped = tuple(file.name for file in own if file.is_skipped)
            own = tuple(file for file in own if not file.is_skipped)
            own = with_last_good(own, before, self._faults)
            self.files = with_ids(own, shipped_files() if self._has_shipped else ())
            _log_rejected(own)
            found = [
                each for folder in self.folders for each in recordings_among(candidates(folder), folder, str(folder))
            ]
            self.recordings = (*found, *(_shipped_recordings() if self._has_shipped else ()))
            compared = [each for folder in self.folders for each in comparisons_among(candidates(folder), folder)]
            self.comparisons = told_apart((*compared, *(_shipped_comparisons() if self._has_shipped else ())))
        return self.files

    def host(self, folders: Iterable[Path], *, has_shipped: bool) -> None:
        """Host the functions of these folders in place of the ones so far."""
        before = self.folders, self._has_shipped
        self.folders, self._has_shipped = tuple(folders), has_shipped
        if before != (self.folders, self._has_shipped):
            self.reload()

    @property
    def runs(self) -> HostedRuns:
        """The stored runs."""
        return tuple(each for each in self.recordings if each.is_run)

    def runs_of(self, hosted: HostedFunction) -> HostedRuns:
        """The stored runs of a function."""
        return runs_of(hosted.function, hosted.file.group, self.runs) if hosted.function else ()

    def reload_changed(self) -> bool:
        """Read the files again if one of them changed, came or went; whether that was so."""
        is_changed = self._marked() != self._marks
        if is_changed:
            self.reload()
            _log.info("functions: read again, %d files, %d runs", len(self.files), len(self.runs))
        return is_changed

    def reload_settled(self) -> bool:
        """Read the files again if some changed, and are the same as at the look before: one may be half written."""
        before, self._seen = self._seen, self._marked()
        return self._seen == before and self.reload_changed()

    def _faults(self, files: HostedFiles) -> Faults:
        """Return findings of files over the catalogue that fits each best; without catalogues no file counts as good."""
        found: dict[Path, tuple[Finding, ...]] = {}
        for hosted in self._catalogues:
            for each in built_over(files, expanded_of(hosted.catalogue)):
                now = () if each.resolved else each.findings
                found[each.file.path] = min(found.get(each.file.path, now), now, key=len)
        return found

    def _marked(self) -> Marks:
        return marks_of(path for folder in self.folders for path in candidates(folder))


@lru_cache(maxsize=16)
def functions_over(files: HostedFiles, catalogue: Catalogue) -> tuple[HostedFunction, ...]:
    """Every function of a service, built over a catalogue. Those of one folder may use what others of it define."""
    return built_over(files, catalogue)


def built_over(files: HostedFiles, catalogue: Catalogue) -> tuple[HostedFunction, ...]:
    """The same over a catalogue that does not last, such as one with an overlay that is tried."""
    groups = dict.fromkeys(file.group for file in files)
    built = [each for group in groups for each in _built([f for f in files if f.group == group], catalogue)]
    return tuple(sorted(built, key=lambda each: (each.file.is_shipped, each.id)))


def function_over(files: HostedFiles, catalogue: Catalogue, function_id: str) -> HostedFunction:
    """A function of a service by its id. Raises NotFound with the nearest ids."""
    return _function_with_id(function_id, {each.id: each for each in functions_over(files, catalogue)})


def file_of(files: HostedFiles, function_id: str) -> HostedFile:
    """The file of a function by its id. Raises NotFound with the nearest ids."""
    return _function_with_id(function_id, {each.id: each for each in files})


def _function_with_id(function_id: str, known: Mapping[str, Found]) -> Found:
    if function_id not in known:
        raise NotFound(f"Unknown function {function_id!r}.", nearest(function_id[:100], known))
    return known[function_id]


def buildable(files: HostedFiles, catalogue: Catalogue) -> HostedFiles:
    """The files that may build over a catalogue: no shipped one does without a branch of functions.

    To find out by trying takes time, since near names are looked for.
    """
    has_interfaces = any(child.name == FUNCTION_BRANCH for root in catalogue.roots for child in root.children)
    return files if has_interfaces else tuple(file for file in files if not file.is_shipped)


@lru_cache(maxsize=64)
def _read(file: HostedFile) -> FunctionFile:
    """Read a file once, however many catalogues it is built over."""
    return read_function_file(file.data, file.name)


@collector_paused()
def _built(files: Sequence[HostedFile], catalogue: Catalogue) -> Iterator[HostedFunction]:
    checked, _ = check_files([_read(file) for file in files], catalogue)
    declared = {each.resolved.name for each in checked if each.resolved and each.is_declaration}
    pairs = zip(files, checked, strict=True)
    return (HostedFunction(f, c.sound, c.findings) for f, c in pairs if not _is_made(c, declared))


def _is_made(checked: CheckedFunction, declared: set[str]) -> bool:
    """Whether it is Function JSON beside the declaration that it was made of, which counts."""
    return checked.resolved is not None and not checked.is_declaration and checked.resolved.name in declared


@lru_cache(maxsize=1)
def _shipped_recordings() -> HostedRuns:
    return tuple(recordings_among(sorted(EXAMPLES.glob(f"*/*{RUN_ENDING}")), EXAMPLES, SHIPPED))


@lru_cache(maxsize=1)
def _shipped_comparisons() -> HostedComparisons:
    return tuple(comparisons_among(sorted(EXAMPLES.glob(f"*/{COMPARISON_FILE}")), EXAMPLES))


def _log_rejected(files: Iterable[HostedFile]) -> None:
    for file in files:
        if file.rejected:
            _log.warning("%s: the file has errors; the last good state stays", file.name)
            log_findings(file.rejected)


@lru_cache(maxsize=4)
def _digest(files: HostedFiles) -> str:
    return digest_of(b"\0".join(part for file in files for part in (file.id.encode(), file.name.encode(), file.data)))
