"""Unpack the source archive of a release, safely: everything is checked before anything is written.

An archive comes from elsewhere. Paths that leave the folder, links out of it, devices, too many or too large files,
and archives that unpack to far more than they are, are refused, whether the file is one that would be kept or not.
"""

import errno
import gzip
import io
import lzma
import stat
import struct
import tarfile
import zipfile
import zlib
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path, PurePosixPath
from typing import IO, Literal, NamedTuple

from sigcat.errors import InputRefused
from sigcat.file_kind import ROOT_NAME
from sigcat.limits import DEFAULT_ARCHIVE_LIMITS, ArchiveLimits

Kind = Literal["file", "folder", "link", "device"]

ROOT_FILE = f"spec/{ROOT_NAME}"
"""Entries that make an archive one of a release."""
KEPT_FOLDERS = frozenset(("spec", "overlays"))
KEPT_FILES = frozenset(("LICENSE", "LICENSE.txt", "VERSION", "CHANGELOG.md"))
"""Kept entries at the top of a release; documentation and build files are not kept."""


class ArchiveRefused(InputRefused):
    """The archive cannot be used; its text says why."""


class Entry(NamedTuple):
    """One entry of an archive, not yet trusted."""

    name: str
    kind: Kind
    size: int
    target: str = ""
    """Target of a link."""


_Opened = Iterator[tuple[Entry, IO[bytes] | None]]
_BROKEN = (
    tarfile.TarError,
    zipfile.BadZipFile,
    zlib.error,
    lzma.LZMAError,
    gzip.BadGzipFile,
    struct.error,
    EOFError,
    ValueError,
    OverflowError,
    NotImplementedError,
    RuntimeError,
    LookupError,
)  # fmt: skip
_CHUNK = 64 * 1024
_LARGEST_DIRECTORY = 8 * 1024 * 1024


def unpack(archive: Path, folder: Path, limits: ArchiveLimits = DEFAULT_ARCHIVE_LIMITS) -> tuple[PurePosixPath, ...]:
    """Unpack what a release needs of `archive` into `folder`, which is empty; the paths written, below `folder`.

    Raises ArchiveRefused before anything is written if any entry cannot be trusted, or without a tree.
    """
    top = _top_folder(_checked(archive, limits))
    written: list[PurePosixPath] = []
    with _entries(archive, limits) as entries:
        for entry, content in entries:
            path = _kept_path(entry, top)
            if path is None or content is None:
                continue
            _write(content, folder / path, entry)
            written.append(path)
    return tuple(written)


def _checked(archive: Path, limits: ArchiveLimits) -> list[Entry]:
    """Every entry of the archive. Raises ArchiveRefused at the first that is not to be trusted."""
    found: dict[str, Entry] = {}
    total = 0
    with _entries(archive, limits) as entries:
        for entry, _ in entries:
            _check_path(entry, limits)
            key = entry.name.rstrip("/")
            if key in found and not (entry.kind == found[key].kind == "folder"):
                raise ArchiveRefused(f"{_shown(entry.name)} is in the archive twice")
            found[key] = entry
            total += entry.size
            if entry.size < 0:
                raise ArchiveRefused(f"{_shown(entry.name)} has a size below zero")
            if total > limits.unpacked_bytes:
                raise ArchiveRefused(f"the archive unpacks to more than {limits.unpacked_bytes:,} bytes")
            if len(found) > limits.entries:
                raise ArchiveRefused(f"the archive has more than {limits.entries:,} files")
    checked = list(found.values())
    top = _top_folder(checked)
    for entry in checked:
        _check_kind(entry, _kept_path(entry, top) is not None, limits)
    return checked


def _check_path(entry: Entry, limits: ArchiveLimits) -> None:
    names = entry.name.rstrip("/").split("/")
    drive = len(names[0]) > 1 and names[0][1] == ":"
    if entry.name.startswith("/") or drive or "\\" in entry.name or ".." in names:
        raise ArchiveRefused(f"{_shown(entry.name)} leads out of the folder in which the archive is unpacked")
    if not entry.name.isprintable() or "" in names or "." in names[1:]:
        raise ArchiveRefused(f"{_shown(entry.name)} is not a usable path")
    if len(entry.name) > limits.path_characters or len(names) > limits.path_names:
        raise ArchiveRefused(f"{_shown(entry.name)} is too long a path")


def _check_kind(entry: Entry, is_kept: bool, limits: ArchiveLimits) -> None:
    if entry.kind == "device":
        raise ArchiveRefused(f"{_shown(entry.name)} is neither a file nor a folder")
    if entry.kind == "link" and (is_kept or _leads_out(entry)):
        raise ArchiveRefused(f"{_shown(entry.name)} is a link, to {_shown(entry.target)}")
    if is_kept and entry.size > limits.file_bytes:
        message = f"{_shown(entry.name)} has {entry.size:,} bytes; the limit is {limits.file_bytes:,}"
        raise ArchiveRefused(message)


def _leads_out(link: Entry) -> bool:
    """Whether the target of a link, seen from its folder, is not below the archive's top."""
    if link.target.startswith("/") or "\\" in link.target or ":" in link.target:
        return True
    depth = len(PurePosixPath(link.name).parent.parts)
    for name in PurePosixPath(link.target).parts:
        depth += -1 if name == ".." else 1
        if depth < 1:
            return True
    return False


def _top_folder(entries: Iterable[Entry]) -> str:
    """The folder that contains `spec`, as GitHub packs it, with its slash; the uppermost one if there are several."""
    names = [entry.name.removeprefix("./") for entry in entries if entry.kind == "file"]
    tops = [name.removesuffix(ROOT_FILE) for name in names if name == ROOT_FILE or name.endswith(f"/{ROOT_FILE}")]
    if not tops:
        raise ArchiveRefused(f"the archive is not a release of VSS: it has no {ROOT_FILE}")
    return min(tops, key=lambda top: (top.count("/"), top))


def _kept_path(entry: Entry, top: str) -> PurePosixPath | None:
    """Return the path of an entry below the folder of the release; None for a folder, and for skipped entries."""
    if entry.kind == "folder":
        return None
    name = entry.name.removeprefix("./")
    if not name.startswith(top):
        return None
    path = PurePosixPath(name.removeprefix(top))
    if len(path.parts) == 1:
        return path if path.name in KEPT_FILES else None
    return path if path.parts[0] in KEPT_FOLDERS else None


def _write(content: IO[bytes], target: Path, entry: Entry) -> None:
    left = entry.size
    try:
        target.parent.mkdir(parents=True, exist_ok=True)
        with target.open("xb") as file:
            while left > 0 and (chunk := content.read(min(left, _CHUNK))):
                file.write(chunk)
                left -= len(chunk)
    except (FileExistsError, NotADirectoryError):
        raise ArchiveRefused(f"{_shown(entry.name)} is in the archive twice") from None
    if left:
        raise ArchiveRefused(f"{_shown(entry.name)} is not whole: {left:,} bytes are missing")


# -- tar and zip --------------------------------------------------------------------------------------------------


@contextmanager
def _entries(archive: Path, limits: ArchiveLimits) -> Iterator[_Opened]:
    """The entries of a tar, tar.gz or zip file, recognized by its first bytes, each with its content if it is a file."""
    with archive.open("rb") as file:
        start = file.read(512)
        file.seek(0)
        try:
            if start[:4] in (b"PK\x03\x04", b"PK\x05\x06"):
                yield _zip_entries(file, limits)
            elif start[:2] == b"\x1f\x8b":
                yield _tar_entries(_Growing(gzip.GzipFile(fileobj=file), archive.stat().st_size, limits))
            elif start[257:262] == b"ustar":
                yield _tar_entries(file)
            else:
                raise ArchiveRefused("the file is neither a tar.gz, a tar nor a zip archive")
        except _BROKEN as error:
            raise ArchiveRefused(f"the archive is damaged or not whole: {error or type(error).__name__}") from None
        except OSError as error:
            if error.errno != errno.EINVAL:
                raise
            raise ArchiveRefused("the archive is damaged: it points to before its beginning") from None


class _Growing(io.RawIOBase):
    """Yield the unpacked bytes of a packed file, as far as they stay within the limits."""

    def __init__(self, file: IO[bytes] | gzip.GzipFile, packed_bytes: int, limits: ArchiveLimits) -> None:
        self._file = file
        self._read = 0
        self._most = limits.unpacked_bytes + limits.entries * 1024
        self._allowed = limits.free_bytes + packed_bytes * limits.ratio
        self._ratio = limits.ratio

    def read(self, size: int = -1) -> bytes:
        """The next bytes. Raises ArchiveRefused where there are too many of them."""
        data = self._file.read(_CHUNK if size < 0 else size)
        self._read += len(data)
        if self._read > self._most:
            raise ArchiveRefused(f"the archive unpacks to more than {self._most:,} bytes")
        if self._read > self._allowed:
            raise ArchiveRefused(f"the archive unpacks to more than {self._ratio} times its size")
        return data


def _tar_entries(file: IO[bytes] | io.RawIOBase) -> _Opened:
    with tarfile.open(fileobj=file, mode="r|") as tar:
        for member in tar:
            entry = _tar_entry(member)
            yield entry, tar.extractfile(member) if entry.kind == "file" else None


def _tar_entry(member: tarfile.TarInfo) -> Entry:
    if member.issym():
        return Entry(member.name, "link", 0, member.linkname)
    if member.islnk():
        return Entry(member.name, "link", 0, f"/{member.linkname}")
    if member.isdir():
        return Entry(member.name, "folder", 0)
    is_plain = member.isreg() and not member.issparse()
    return Entry(member.name, "file" if is_plain else "device", member.size)


def _zip_entries(file: IO[bytes], limits: ArchiveLimits) -> _Opened:
    _check_directory(file)
    with zipfile.ZipFile(file) as archive:
        _check_growth(archive, limits)
        for member in archive.infolist():
            entry = _zip_entry(archive, member)
            if entry.kind != "file":
                yield entry, None
                continue
            with archive.open(member) as content:
                yield entry, content


def _check_directory(file: IO[bytes]) -> None:
    """Refuse a directory so long that reading it alone would hurt."""
    size = file.seek(0, io.SEEK_END)
    file.seek(max(0, size - 65_557))
    tail = file.read()
    end = tail.rfind(b"PK\x05\x06")
    if end < 0 or len(tail) < end + 22:
        raise ArchiveRefused("the archive is damaged or not whole: its directory is missing")
    (length,) = struct.unpack_from("<I", tail, end + 12)
    if length > _LARGEST_DIRECTORY:
        raise ArchiveRefused("the archive has too many files")


def _check_growth(archive: zipfile.ZipFile, limits: ArchiveLimits) -> None:
    packed = sum(member.compress_size for member in archive.infolist())
    unpacked = sum(member.file_size for member in archive.infolist())
    if unpacked > limits.unpacked_bytes:
        raise ArchiveRefused(f"the archive unpacks to more than {limits.unpacked_bytes:,} bytes")
    if unpacked > limits.free_bytes + packed * limits.ratio:
        raise ArchiveRefused(f"the archive unpacks to more than {limits.ratio} times its size")


def _zip_entry(archive: zipfile.ZipFile, member: zipfile.ZipInfo) -> Entry:
    mode = member.external_attr >> 16
    name = member.orig_filename
    if stat.S_ISLNK(mode):
        target = archive.read(member)[:1024].decode("utf-8", "replace") if member.file_size <= 4096 else "/"
        return Entry(name, "link", 0, target)
    if member.is_dir():
        return Entry(name, "folder", 0)
    is_plain = stat.S_IFMT(mode) in (0, stat.S_IFREG) and not member.flag_bits & 1
    return Entry(name, "file" if is_plain else "device", member.file_size)


def _shown(name: str) -> str:
    return repr(name if len(name) <= 80 else f"{name[:77]}...")
