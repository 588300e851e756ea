"""Function files that a service hosts: those in a folder, and those that sigcat ships, with the names that addresses have."""

import logging
import os
from collections.abc import Callable, Iterable, Iterator
from functools import lru_cache
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from sigcat import codes
from sigcat.data import EXAMPLES
from sigcat.file_kind import ENDINGS, ending_of, file_kind
from sigcat.findings import Finding
from sigcat.function.hosted_runs import ENDING, free_id
from sigcat.limits import HOSTED_FUNCTION_BYTES, RECOGNITION_BYTES

FILE = "function.yaml"
SHIPPED = "shipped"
_KINDS = ("function", "function json")
_log = logging.getLogger("sigcat.hosting")


class HostedFile(NamedTuple):
    """A function file of a service."""

    id: str
    """Name in addresses: of `NAME/function.yaml` its folder, of any other file its own."""
    name: str
    """Name in findings."""
    data: bytes
    group: str
    """The folder that the configuration names; files of one group are read together."""
    rejected: tuple[Finding, ...] = ()
    """Findings of a newer state that was not taken."""

    @property
    def is_skipped(self) -> bool:
        """Whether the file is too large, and no earlier state of it is hosted."""
        return not self.data and bool(self.rejected)

    @property
    def is_shipped(self) -> bool:
        """Whether sigcat brings it along."""
        return self.group == SHIPPED

    @property
    def is_json(self) -> bool:
        """Whether it is Function JSON, and no declaration."""
        return ending_of(self.name) == ".json"

    @property
    def path(self) -> Path:
        """Path of a file of the operator."""
        return Path(self.group, *PurePosixPath(self.name).parts[1:])


HostedFiles = tuple[HostedFile, ...]


@lru_cache(maxsize=1)
def shipped_files() -> HostedFiles:
    """The functions that sigcat brings along."""
    found = sorted(EXAMPLES.glob(f"*/{FILE}"))
    return tuple(HostedFile(path.parent.name, FILE, path.read_bytes(), SHIPPED) for path in found)


def candidates(folder: Path, unreadable: Callable[[OSError], None] | None = None) -> Iterator[Path]:
    """Files below a folder that may be functions, or runs of them, in order; hidden ones are skipped.

    `unreadable` is called for each folder that cannot be read.
    """
    found: list[Path] = []
    for here, folders, files in os.walk(folder, onerror=unreadable):
        folders[:] = (name for name in folders if not name.startswith("."))
        found += (Path(here, name) for name in files if not name.startswith("."))
    yield from (path for path in sorted(found) if ending_of(path.name) in (*ENDINGS, ENDING) and path.is_file())


def _log_unreadable(error: OSError) -> None:
    _log.warning("%s: %s; nothing in it is served", error.filename, error.strerror or error)


def files_in(folder: Path, before: Iterable[HostedFile] = ()) -> Iterator[HostedFile]:
    """The functions of a folder. A file that was one before still is, whatever it holds now; it may have to be written again."""
    hosted = {file.path: file for file in before if file.group == str(folder)}
    for path in candidates(folder, _log_unreadable):
        if ending_of(path.name) == ENDING:
            continue
        try:
            with path.open("rb") as opened:  # of a file that is too large, one byte more than the limit
                data = opened.read(HOSTED_FUNCTION_BYTES + 1)
        except OSError as error:
            _log.warning("%s: %s", path, error.strerror or error)
            if path in hosted:
                yield _still(hosted[path], _unreadable(hosted[path].name, error))
            continue
        if path in hosted or file_kind(data[:RECOGNITION_BYTES], path.name) in _KINDS:
            below = path.relative_to(folder)
            name = (Path(folder.name) / below).as_posix()
            file = HostedFile(_own_id(below, folder), name, data, str(folder))
            if len(data) > HOSTED_FUNCTION_BYTES:
                _log.warning("%s: skipped, it has more than %d bytes", path, HOSTED_FUNCTION_BYTES)
                file = _still(hosted.get(path, file._replace(data=b"")), _too_large(name))
            yield file


def _unreadable(name: str, error: OSError) -> Finding:
    message = f"{name!r} cannot be read: {error.strerror or error}."
    return codes.FILE_UNREADABLE.finding(message, name, fix="Let the service read it.")


def _too_large(name: str) -> Finding:
    message = f"The file has more than {HOSTED_FUNCTION_BYTES:,} bytes, the limit of the service."
    return codes.FILE_TOO_LARGE.finding(message, name, fix="Split the function, or move the file out of the folder.")


def _still(file: HostedFile, finding: Finding) -> HostedFile:
    """A file in the state in which it is hosted, and the finding that keeps it there."""
    below = file.path.relative_to(file.group)
    return file._replace(id=_own_id(below, Path(file.group)), rejected=(finding,))


def _own_id(below: Path, folder: Path) -> str:
    stem = below.name.removesuffix(below.suffix).removesuffix(".function")
    return stem if stem != "function" else below.parent.name or folder.name


def with_ids(own: Iterable[HostedFile], shipped: HostedFiles) -> HostedFiles:
    """Files with unique ids: declarations before Function JSON, and the operator's own before shipped ones."""
    by_id: dict[str, HostedFile] = {}
    for file in sorted(own, key=lambda each: ending_of(each.name) == ".json"):
        free = free_id(file.id, by_id)
        by_id[free] = file._replace(id=free)
    return (*by_id.values(), *(file for file in shipped if file.id not in by_id))
