"""The functions that a service hosts, and their runs: those that sigcat ships, and those in folders that its configuration names."""

import logging
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from pathlib import Path
from threading import Lock
from typing import NamedTuple, TypeVar

from sigcat.catalogue.hosting.file_marks import Marks, marks_of
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.interfaces import FUNCTION_BRANCH
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.data import EXAMPLES
from sigcat.digest import digest_of
from sigcat.errors import NotFound
from sigcat.file_kind import ENDINGS, ending_of, file_kind
from sigcat.findings import Finding
from sigcat.function.function_file import CheckedFunction, check_files, read_function_file
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.hosted_comparisons import FILE as COMPARISON_FILE
from sigcat.function.hosted_comparisons import HostedComparisons, comparisons_among, told_apart
from sigcat.function.hosted_runs import ENDING, HostedRuns, runs_among, runs_of
from sigcat.function.hosted_runs import FILE as RUN_FILE
from sigcat.limits import RECOGNITION_BYTES
from sigcat.names import nearest

FILE = "function.yaml"
_SHIPPED = "shipped"
Found = TypeVar("Found")
_KINDS = ("function", "function json")
_log = logging.getLogger("sigcat.hosting")


class HostedFile(NamedTuple):
    """A function file of a service."""

    id: str
    """Name in addresses: of `NAME/function.yaml` its folder, of any other file its own."""
    name: str
    """What findings call it."""
    data: bytes
    group: str
    """The folder that the configuration names; files of one group are read together."""

    @property
    def is_shipped(self) -> bool:
        """Whether sigcat brings it along."""
        return self.group == _SHIPPED

    @property
    def is_json(self) -> bool:
        """Whether it is Function JSON, and no declaration."""
        return ending_of(self.name) == ".json"


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


HostedFiles = tuple[HostedFile, ...]


class FunctionLibrary:
    """The function files of a service. They are replaced as a whole; readers keep those that they hold."""

    def __init__(self, folders: Iterable[Path] = (), *, has_shipped: bool = True) -> None:
        self.folders = tuple(folders)
        self._has_shipped = has_shipped
        self._lock = Lock()
        self.files: HostedFiles = ()
        self.runs: HostedRuns = ()
        self.comparisons: HostedComparisons = ()
        self._marks: Marks = frozenset()
        self.reload()

    @property
    def digest(self) -> str:
        """SHA-256 of the files: it differs as soon as one of them does."""
        return _digest(self.files)

    def reload(self) -> HostedFiles:
        """Read the files again. One that cannot be read is left out, and the log says why."""
        with self._lock:
            self._marks = self._marked()
            own = [file for folder in self.folders for file in _files_in(folder)]
            self.files = _with_ids(own, _shipped() if self._has_shipped else ())
            runs = [run for folder in self.folders for run in runs_among(_candidates(folder), folder, str(folder))]
            self.runs = (*runs, *(_shipped_runs() if self._has_shipped else ()))
            compared = [each for folder in self.folders for each in comparisons_among(_candidates(folder), folder)]
            self.comparisons = told_apart((*compared, *(_shipped_comparisons() if self._has_shipped else ())))
        return self.files

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

    def _marked(self) -> Marks:
        return marks_of(path for folder in self.folders for path in _candidates(folder))


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
    return _named(function_id, {each.id: each for each in functions_over(files, catalogue)})


def file_of(files: HostedFiles, function_id: str) -> HostedFile:
    """The file of a function by its id. Raises NotFound with the nearest ids."""
    return _named(function_id, {each.id: each for each in files})


def _named(function_id: str, known: Mapping[str, Found]) -> Found:
    if function_id not in known:
        raise NotFound(f"There is no function {function_id!r}.", nearest(function_id[:100], known))
    return known[function_id]


def buildable(files: HostedFiles, catalogue: Catalogue) -> HostedFiles:
    """The files that may build over a catalogue: no shipped one does without a branch of functions.

    To find out by trying takes time, since near names are looked for.
    """
    return files if _has_interfaces(catalogue) else tuple(file for file in files if not file.is_shipped)


def _has_interfaces(catalogue: Catalogue) -> bool:
    return any(child.name == FUNCTION_BRANCH for root in catalogue.roots for child in root.children)


@collector_paused()
def _built(files: Sequence[HostedFile], catalogue: Catalogue) -> Iterator[HostedFunction]:
    checked, _ = check_files([read_function_file(file.data, file.name) for file in files], catalogue)
    declared = {each.resolved.name for each in checked if each.resolved and each.is_declaration}
    pairs = zip(files, checked, strict=True)
    return (HostedFunction(f, c.sound, c.findings) for f, c in pairs if not _is_made(c, declared))


def _is_made(checked: CheckedFunction, declared: set[str]) -> bool:
    """Whether it is Function JSON beside the declaration that it was made of, which counts."""
    return checked.resolved is not None and not checked.is_declaration and checked.resolved.name in declared


# -- files --------------------------------------------------------------------------------------------------------


@lru_cache(maxsize=1)
def _shipped() -> HostedFiles:
    found = sorted(EXAMPLES.glob(f"*/{FILE}"))
    return tuple(HostedFile(path.parent.name, FILE, path.read_bytes(), _SHIPPED) for path in found)


@lru_cache(maxsize=1)
def _shipped_runs() -> HostedRuns:
    return tuple(runs_among(sorted(EXAMPLES.glob(f"*/{RUN_FILE}")), EXAMPLES, _SHIPPED))


@lru_cache(maxsize=1)
def _shipped_comparisons() -> HostedComparisons:
    return tuple(comparisons_among(sorted(EXAMPLES.glob(f"*/{COMPARISON_FILE}")), EXAMPLES))


def _candidates(folder: Path) -> Iterator[Path]:
    """Files below a folder that may be functions, or runs of them; what is hidden is not looked at."""
    for path in sorted(folder.rglob("*")):
        is_hidden = any(part.startswith(".") for part in path.relative_to(folder).parts)
        if ending_of(path.name) in (*ENDINGS, ENDING) and not is_hidden and path.is_file():
            yield path


def _files_in(folder: Path) -> Iterator[HostedFile]:
    for path in _candidates(folder):
        if ending_of(path.name) == ENDING:
            continue
        try:
            data = path.read_bytes()
        except OSError as error:
            _log.warning("%s: %s", path, error.strerror or error)
            continue
        if file_kind(data[:RECOGNITION_BYTES], path.name) in _KINDS:
            below = path.relative_to(folder)
            name = (Path(folder.name) / below).as_posix()
            yield HostedFile(_own_id(below, folder), name, data, str(folder))


def _own_id(below: Path, folder: Path) -> str:
    stem = below.name.removesuffix(below.suffix).removesuffix(".function")
    return stem if stem != "function" else below.parent.name or folder.name


def _with_ids(own: Iterable[HostedFile], shipped: HostedFiles) -> HostedFiles:
    """Files with ids of their own: declarations before Function JSON, and those of one's own before shipped ones."""
    by_id: dict[str, HostedFile] = {}
    for file in sorted(own, key=lambda each: ending_of(each.name) == ".json"):
        number, free = 1, file.id
        while free in by_id:
            number += 1
            free = f"{file.id}-{number}"
        by_id[free] = file._replace(id=free)
    return (*by_id.values(), *(file for file in shipped if file.id not in by_id))


@lru_cache(maxsize=4)
def _digest(files: HostedFiles) -> str:
    return digest_of(b"\0".join(part for file in files for part in (file.id.encode(), file.name.encode(), file.data)))
