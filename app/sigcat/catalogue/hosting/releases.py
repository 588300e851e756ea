"""Official releases: fetched once, kept in the user's data folder, each whole or not there at all."""

import datetime as dt
import hashlib
import json
import os
import re
import shutil
import sys
import tempfile
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path, PurePosixPath
from typing import Any, NamedTuple

from sigcat.catalogue.hosting.archive import ROOT_FILE, unpack
from sigcat.catalogue.hosting.download import FetchFailed, FileMissing, Progress, fetch
from sigcat.catalogue.hosting.source import Source, load
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.reading.root_file import types_beside
from sigcat.errors import InputRefused, NotFound, UsageError
from sigcat.findings import has_errors
from sigcat.limits import DEFAULT_ARCHIVE_LIMITS, DEFAULT_FETCH_LIMITS, ArchiveLimits, FetchLimits
from sigcat.names import nearest
from sigcat.real_path import real_path

ADDRESS = "https://github.com/COVESA/vehicle_signal_specification/archive/refs/tags/{name}.tar.gz"
"""Source archive of the tag of a release."""
RECORD = "release.json"

_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._+-]{0,63}")
_SHIPPED = ("vss", "interfaces", "shipped")
"""Names of releases that are available without being pulled."""
_VERSION = re.compile(r"[vV]?([0-9]+(?:\.[0-9]+){1,3}(?:[-._]?[A-Za-z][A-Za-z0-9.]*)?)")
_STATED = "Vehicle.VersionVSS"
_WEB = re.compile(r"https?://")
_SHA256 = re.compile(r"(?:sha256:)?([0-9a-f]{64})")
_UNFINISHED = ".pull-"
_DAY = 24 * 60 * 60
_PIECE = 1024 * 1024


class Release(NamedTuple):
    """A release in the data folder."""

    name: str
    """Tag, such as `v5.0`."""
    folder: Path
    source: str
    """Address or file that it came from."""
    digest: str
    """SHA-256 of the archive. GitHub may pack the same tag again, with another digest."""
    content_digest: str
    """SHA-256 over paths and contents of the unpacked files: the same however it was packed."""
    pulled: str
    """Date and time, UTC, ISO 8601."""
    nodes: int
    """Nodes of the tree, instances expanded."""

    @property
    def spec(self) -> Path:
        """Root file of the tree."""
        return self.folder / ROOT_FILE

    @property
    def types(self) -> tuple[Path, ...]:
        """Files of struct types, if the release has some."""
        return types_beside(self.spec)

    @property
    def overlays(self) -> tuple[Path, ...]:
        """Overlays that came with the release."""
        return tuple(sorted((self.folder / "overlays").rglob("*.vspec")))


class PullLimits(NamedTuple):
    """Bounds on fetching and unpacking."""

    fetch: FetchLimits = DEFAULT_FETCH_LIMITS
    archive: ArchiveLimits = DEFAULT_ARCHIVE_LIMITS


DEFAULT_PULL_LIMITS = PullLimits()


def data_folder() -> Path:
    """The user's data folder of sigcat: SIGCAT_DATA, or else what the platform has for data of applications."""
    if chosen := os.environ.get("SIGCAT_DATA"):
        return Path(chosen).expanduser()
    if base := os.environ.get("XDG_DATA_HOME"):
        return Path(base) / "sigcat"
    if sys.platform == "win32":
        return Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local") / "sigcat"
    if sys.platform == "darwin":
        return Path.home() / "Library" / "Application Support" / "sigcat"
    return Path.home() / ".local" / "share" / "sigcat"


def is_version(text: str) -> bool:
    """Whether a text is a version of VSS, such as `5.0` or `v5.1-rc1`."""
    return _VERSION.fullmatch(text) is not None


def releases_folder(data: Path | None = None) -> Path:
    """The folder of pulled releases, each in a folder of its name."""
    return (data or data_folder()) / "releases"


def release_name(text: str) -> str:
    """The tag that a user means: `5.0` and `V5.0` are `v5.0`; other names stay. Raises UsageError."""
    version = _VERSION.fullmatch(text)
    if version is not None:
        return f"v{version[1]}"
    if not _NAME.fullmatch(text):
        is_of_git = re.search(r"[~^@]|\.\.", text) is not None
        hint = f"for a revision, write git:{text[:80]}" if is_of_git else "write one such as v5.0"
        raise UsageError(f"{text[:80]!r} is not a release name; {hint}")
    return text


def pulled_releases(data: Path | None = None) -> tuple[Release, ...]:
    """The releases in the data folder, oldest version first."""
    folder = releases_folder(data)
    records = sorted(folder.glob(f"*/{RECORD}")) if folder.is_dir() else []
    found = [_recorded(record) for record in records if not record.parent.name.startswith(".")]
    return tuple(sorted((release for release in found if release is not None), key=_age))


def find_release(name: str, data: Path | None = None) -> Release:
    """The pulled release of this name. Raises NotFound, which says how to pull it and what there is."""
    wanted = release_name(name)
    pulled = {release.name: release for release in pulled_releases(data)}
    if wanted not in pulled:
        there = f" Pulled are {', '.join(pulled)}." if pulled else ""
        near = nearest(wanted, (*pulled, *_SHIPPED), cutoff=60)
        if is_version(wanted):
            shipped = " 'shipped' is VSS 6.0." if wanted == "v6.0" else ""
            raise NotFound(f"release {wanted} is not pulled.{there} Run `sigcat pull {wanted}`.{shipped}", near)
        hint = f" Did you mean {' or '.join(near)}?" if near else ""
        if not near and wanted.lstrip("vV")[:1].isdigit():
            hint = " Releases of VSS have names such as v5.0; `sigcat pull v5.0` fetches one."
        if ".." in wanted:
            hint = f" For revisions, write git:{wanted}."
        raise NotFound(f"no file, folder or release is named {wanted!r}.{hint}{there}", near)
    return pulled[wanted]


def is_pulled(name: str, data: Path | None = None) -> bool:
    """Whether the release of this name is in the data folder."""
    return _recorded(releases_folder(data) / release_name(name) / RECORD) is not None


def pull(
    name: str,
    origin: str = "",
    digest: str = "",
    *,
    replaces: bool = False,
    allows_private: bool = False,
    data: Path | None = None,
    progress: Progress | None = None,
    limits: PullLimits = DEFAULT_PULL_LIMITS,
) -> Release:
    """Fetch a release, check it and keep it; one that is here already is returned as it is, unless `replaces`.

    `origin` is an address or a file instead of COVESA's GitHub, and may be a private address if that is allowed; `digest` the
    SHA-256 that the archive must have.
    Raises UsageError, FetchFailed or InputRefused, and then nothing of it is kept.
    """
    name, digest = release_name(name), _sha256(digest)
    if allows_private and not _WEB.match(origin):
        raise UsageError("--allow-private is for the address that --from names, and none is named")
    if not origin and not is_version(name):
        raise UsageError(
            f"{name!r} is not a version of VSS such as v5.0. For another release, name its address or file with --from"
        )
    folder = releases_folder(data)
    here = None if replaces else _recorded(folder / name / RECORD)
    if here is not None:
        return _same(here, digest)
    folder.mkdir(parents=True, exist_ok=True)
    _remove_unfinished(folder)
    with _unfinished(folder) as work:
        archive = work / "archive"
        source = _bring(name, origin, archive, allows_private, progress, limits)
        release = _unpacked(name, source, archive, digest, limits)
        if replaces and (folder / name).exists():
            (folder / name).rename(work / "replaced")
        return _keep(release, folder / name)


def _unpacked(name: str, source: str, archive: Path, digest: str, limits: PullLimits) -> Release:
    """A release, unpacked beside its archive, in a folder that is removed if something is wrong with it."""
    content = archive.with_name("content")
    found = _digest_of(archive)
    if digest and found != digest:
        raise InputRefused(f"the archive has the SHA-256 {found}, not {digest}; nothing was kept")
    content.mkdir()
    files = unpack(archive, content, limits.archive)
    nodes = len(_tree(name, content).nodes)
    release = Release(name, content, source, found, _content_digest(content, files), _now(), nodes)
    _write_record(release)
    return release


def _sha256(text: str) -> str:
    match = _SHA256.fullmatch(text.strip().lower())
    if text and match is None:
        raise UsageError(f"{text[:80]!r} is not a SHA-256 of 64 hexadecimal digits")
    return match[1] if match else ""


def _same(release: Release, digest: str) -> Release:
    if digest and release.digest != digest:
        message = (
            f"{release.name} is here already, from an archive with the SHA-256 {release.digest}, not {digest}; "
            f"pull it with --force to replace it"
        )
        raise InputRefused(message)
    return release


def _bring(
    name: str, origin: str, archive: Path, allows_private: bool, progress: Progress | None, limits: PullLimits
) -> str:
    """Put the archive in its place; the address or file that it came from."""
    if _WEB.match(origin):
        return fetch(
            origin, archive, is_named=True, allows_private=allows_private, progress=progress, limits=limits.fetch
        )
    if not origin:
        return _fetch_official(ADDRESS.format(name=name), archive, progress, limits)
    if re.match(r"[A-Za-z][A-Za-z0-9+.-]+:", origin):
        raise UsageError(f"--from {origin}: name an http or https address, or a file")
    file = Path(origin)
    if file.is_dir():
        raise UsageError(
            f"--from {origin} must be an archive (.tar.gz), not a folder. Use the tree in it with -s {origin}."
        )
    if not file.is_file():
        raise UsageError(f"--from {origin}: there is no such file")
    if file.stat().st_size > limits.fetch.bytes:
        raise InputRefused(f"{origin} has more than {limits.fetch.bytes:,} bytes")
    shutil.copyfile(file, archive)
    return str(real_path(file))


def _fetch_official(address: str, archive: Path, progress: Progress | None, limits: PullLimits) -> str:
    try:
        return fetch(address, archive, progress=progress, limits=limits.fetch)
    except FileMissing:
        raise
    except FetchFailed as error:
        hint = f"Without a network, bring {address} here and name the file with --from"
        raise FetchFailed(f"{error}. {hint}") from None


def _digest_of(file: Path) -> str:
    sha = hashlib.sha256()
    with file.open("rb") as content:
        while piece := content.read(_PIECE):
            sha.update(piece)
    return sha.hexdigest()


def _content_digest(folder: Path, files: Sequence[PurePosixPath]) -> str:
    lines = sorted(f"{file}\0{_digest_of(folder / file)}\n" for file in files)
    return hashlib.sha256("".join(lines).encode()).hexdigest()


def _tree(name: str, folder: Path) -> Catalogue:
    """The tree in a folder. Raises InputRefused if it does not load, or says that it is another release."""
    spec = folder / ROOT_FILE
    catalogue = load(Source(name, name, spec, types=types_beside(spec), release=name))
    if has_errors(catalogue.findings) or not catalogue.roots:
        prefix = f"{folder}{os.sep}"
        findings = [finding._replace(file=finding.file.removeprefix(prefix)) for finding in catalogue.findings]
        errors = tuple(finding for finding in findings if finding.severity == "error")
        raise InputRefused(f"the tree of {name} cannot be read; nothing was kept", errors)
    stated = _stated_version(catalogue)
    if stated is not None and _VERSION.fullmatch(name) and _numbers(name) != _numbers(stated):
        raise InputRefused(f"the archive is release {stated} by its {_STATED}, not {name}; nothing was kept")
    return catalogue


def _stated_version(catalogue: Catalogue) -> str | None:
    """The version that the tree says it is; None if it does not."""
    nodes = [catalogue.get(f"{_STATED}.{part}") for part in ("Major", "Minor", "Patch")]
    numbers = [str(node.values.get("default")) for node in nodes if node is not None]
    return f"v{'.'.join(numbers)}" if len(numbers) == len(nodes) and all(map(str.isdecimal, numbers)) else None


def _numbers(version: str) -> list[int]:
    """The numbers of a version, without zeros at the end and without what follows them, as in `v6.0-rc1`."""
    numbers = [int(number) for number in version.removeprefix("v").partition("-")[0].split(".") if number.isdecimal()]
    while numbers and not numbers[-1]:
        numbers.pop()
    return numbers


# -- the data folder ----------------------------------------------------------------------------------------------


@contextmanager
def _unfinished(folder: Path) -> Iterator[Path]:
    """A folder for work that is not done, beside the finished ones so that a rename finishes it."""
    work = Path(tempfile.mkdtemp(dir=folder, prefix=f"{_UNFINISHED}{os.getpid()}-"))
    try:
        yield work
    finally:
        shutil.rmtree(work, ignore_errors=True)


def _remove_unfinished(folder: Path) -> None:
    """Remove what killed processes left; a folder of a process that lives is left alone."""
    for left in folder.glob(f"{_UNFINISHED}*"):
        owner = left.name.removeprefix(_UNFINISHED).partition("-")[0]
        if _is_abandoned(left, int(owner) if owner.isdecimal() else 0):
            shutil.rmtree(left, ignore_errors=True)


def _is_abandoned(folder: Path, owner: int) -> bool:
    try:
        if time.time() - folder.stat().st_mtime > _DAY:
            return True
        if os.name != "posix" or owner <= 0:
            return False
        os.kill(owner, 0)
    except ProcessLookupError:
        return True
    except OSError:
        return False
    return False


def _keep(release: Release, folder: Path) -> Release:
    """Move a finished release to its place, at once. One that another process put there first is taken instead."""
    try:
        release.folder.rename(folder)
    except OSError:
        other = _recorded(folder / RECORD)
        if other is None:
            raise
        return _same(other, release.digest)
    return release._replace(folder=folder)


def _write_record(release: Release) -> None:
    record = {name: value for name, value in release._asdict().items() if name != "folder"}
    text = json.dumps(record, indent=2)
    (release.folder / RECORD).write_text(f"{text}\n", encoding="utf-8")


def _recorded(record: Path) -> Release | None:
    """The release that a record describes; None if it does not exist or cannot be read."""
    try:
        data: Any = json.loads(record.read_text(encoding="utf-8"))
        release = Release(**data, folder=record.parent)
    except (OSError, ValueError, TypeError):
        return None
    return release if release.name == record.parent.name and release.spec.is_file() else None


def _now() -> str:
    return dt.datetime.now(dt.UTC).isoformat(timespec="seconds")


def _age(release: Release) -> tuple[list[int], str]:
    return [int(number) for number in re.findall(r"[0-9]+", release.name)], release.name
