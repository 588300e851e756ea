"""The record of converted values: of which release the values are in files that state no units.

The file `.sigcat-migrated` is in the folder of the project. For each recording it has the release of each converted
signal, and the hash of the recording, by which a renamed or copied one is known.
"""

import json
from collections.abc import Iterable, Mapping
from os.path import relpath
from pathlib import Path
from typing import Any, NamedTuple

from sigcat.digest import digest_of
from sigcat.errors import UsageError
from sigcat.migration.changed_text import Migrated
from sigcat.real_path import real_path

RECORD = ".sigcat-migrated"
_PROJECTS = (RECORD, "sigcat.toml")


class Recorded(NamedTuple):
    """A file whose values were converted."""

    releases: Mapping[str, str]
    """By the path of the signal."""
    sha256: str
    """Digest of the file, after the conversion."""


Record = Mapping[Path, Recorded]
"""By the path of the file."""


def folder_of_record(path: Path, folder: Path) -> Path:
    """Return the folder with the record of a file: that of its project, otherwise `folder`."""
    above = real_path(path).parents
    return next((each for each in above if any((each / name).is_file() for name in _PROJECTS)), real_path(folder))


def read_record(folder: Path) -> Record:
    """Return the record in a folder; empty if there is none. Raises UsageError for a damaged one."""
    file = folder / RECORD
    if not file.is_file():
        return {}
    try:
        data = json.loads(file.read_bytes())
        return {folder / name: _recorded(entry) for name, entry in data.items()}
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        message = "is damaged, and values would be converted twice without it: restore it, for example from git"
        raise UsageError(f"{file} {message}") from None


def _recorded(entry: Any) -> Recorded:
    releases, digest = entry["releases"], entry["sha256"]
    if not all(isinstance(text, str) for text in (*releases, *releases.values(), digest)):
        raise TypeError(entry)
    return Recorded(dict(releases), digest)


def releases_of(record: Record, path: Path, data: bytes) -> Mapping[str, str]:
    """Return the releases of the values of a file, by the path of their signal."""
    known = record.get(real_path(path))
    if known is None:
        digest = digest_of(data)
        known = next((each for each in record.values() if each.sha256 == digest), None)
    return known.releases if known is not None else {}


def record_bytes(folder: Path, before: Record, files: Iterable[Migrated], release: str) -> bytes:
    """Return the record of a folder after a migration of files to a release."""
    after = dict(before)
    for file in files:
        path = real_path(Path(file.file))
        earlier = releases_of(before, path, file.before)
        if file.values or (earlier and file.is_changed):
            releases = {**earlier, **dict.fromkeys(file.values, release)}
            after[path] = Recorded(releases, digest_of(file.after))
    named = {relpath(path, folder): entry._asdict() for path, entry in sorted(after.items())}
    return (json.dumps(named, indent=2, sort_keys=True) + "\n").encode()
