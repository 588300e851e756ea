"""Layers: a base tree or an overlay with everything that it includes, in the order in which it applies."""

import errno
import os
import stat
from collections.abc import Iterator, Sequence
from functools import cached_property
from pathlib import Path

from sigcat import codes
from sigcat.catalogue.reading.compiled_tree import compiled_file, compiled_files, is_shipped, keep
from sigcat.catalogue.reading.statement import Origin, SourceFile, Statement
from sigcat.catalogue.reading.vspec_file import Include, VspecFile, parse_vspec
from sigcat.digest import digest_of
from sigcat.file_kind import TREE_ENDINGS
from sigcat.findings import Finding
from sigcat.limits import DEFAULT_LIMITS, REFUSED_INCLUDES, Limits
from sigcat.open_files import made_once, open_text
from sigcat.real_path import real_path


class Layer:
    """Statements of one tree or overlay, included files after the file that includes them. Frozen after reading."""

    def __init__(
        self,
        name: str,
        is_overlay: bool,
        files: tuple[SourceFile, ...],
        statements: tuple[Statement, ...],
        findings: tuple[Finding, ...],
    ) -> None:
        self.name = name
        self.is_overlay = is_overlay
        self.files = files
        self.statements = statements
        self.findings = findings

    def __repr__(self) -> str:
        return f"<Layer {self.name}: {len(self.statements)} statements from {len(self.files)} files>"

    @cached_property
    def digest(self) -> str:
        """SHA-256 over the digests of all files, in order."""
        return digest_of("".join(file.digest for file in self.files).encode())


class _Reading:
    """One layer while it is read: data for all of its files, and the results so far."""

    def __init__(self, path: Path, include_dirs: Sequence[Path], limits: Limits, *, is_overlay: bool) -> None:
        self.is_overlay = is_overlay
        self.name = str(path)
        self.folders = (path.parent, *include_dirs)
        self.allowed = tuple(real_path(folder) for folder in self.folders)
        self.limits = limits
        self.files: dict[Path, VspecFile] = {}
        self.statements: list[Statement] = []
        self.findings: list[Finding] = []
        self.real_paths: dict[Path, Path] = {}
        self.is_inside: dict[Path, bool] = {}
        self.is_compiled = limits == DEFAULT_LIMITS and is_shipped(path)
        self.compiled = compiled_files() if self.is_compiled else {}

    def finished(self) -> Layer:
        """The layer, with the findings of the files before those of the includes."""
        files = tuple(file.source for file in self.files.values())
        findings = [finding for file in self.files.values() for finding in file.findings]
        return Layer(self.name, self.is_overlay, files, tuple(self.statements), (*findings, *self.findings))


def read_layer(
    path: Path,
    include_dirs: Sequence[Path] = (),
    *,
    is_overlay: bool = False,
    limits: Limits = DEFAULT_LIMITS,
) -> Layer:
    """Read a vspec file and all that it includes.

    Includes are looked for beside `path`, in `include_dirs`, and beside the file that includes, in this order. They
    have to be in one of these folders or below. A file that cannot be read is a finding; the rest is read.
    """
    reading = _Reading(path, include_dirs, limits, is_overlay=is_overlay)
    file = _read_file(path, reading, Origin(str(path), 0, 0))
    if file is not None:
        if not (file.statements or file.includes or file.findings):
            rule = codes.OVERLAY_EMPTY if is_overlay else codes.TREE_EMPTY
            reading.findings.append(rule.finding("The file has no nodes.", str(path)))
        _apply(file, path, "", reading, (real_path(path),))
    if reading.is_compiled:
        keep(reading.files.values(), reading.compiled)
    return reading.finished()


def layer_from_text(text: bytes, name: str, *, is_overlay: bool = True, limits: Limits = DEFAULT_LIMITS) -> Layer:
    """A layer from text that is not in a file, such as a posted overlay. It cannot include files."""
    source = SourceFile(name, name if is_overlay else "", digest_of(text))
    file = parse_vspec(text, source, limits)
    refused = [_refused_include(include, name) for include in file.includes[:REFUSED_INCLUDES]]
    if (more := len(file.includes) - REFUSED_INCLUDES) > 0:
        refused.append(codes.INCLUDE_OUTSIDE.finding(f"{more:,} more includes are not read.", name))
    return Layer(name, is_overlay, (source,), file.statements, (*file.findings, *refused))


def _refused_include(include: Include, name: str) -> Finding:
    message = f"Include {include.target!r} is not read: only files can include files."
    return codes.INCLUDE_OUTSIDE.finding(message, name, include.line, include.column)


def _apply(file: VspecFile, path: Path, prefix: str, reading: _Reading, above: tuple[Path, ...]) -> None:
    reading.statements.extend(file.statements if not prefix else [s.placed(prefix) for s in file.statements])
    for include in file.includes:
        for found, target in _included(file, path, include, reading, above):
            deeper = ".".join(part for part in (prefix, include.prefix) if part)
            _apply(found, target, deeper, reading, (*above, reading.real_paths[target]))


def _included(
    file: VspecFile, path: Path, include: Include, reading: _Reading, above: tuple[Path, ...]
) -> Iterator[tuple[VspecFile, Path]]:
    """The file that an include names, or nothing and a finding."""
    origin = Origin(file.source.name, include.line, include.column)
    target = _find(include.target, (*reading.folders, path.parent))
    real = _real(target, reading) if target is not None else None
    if target is None or real is None:
        looked = ", ".join(f"'{folder}'" for folder in dict.fromkeys((*reading.folders, path.parent)))
        message = f"Include {include.target!r} was not found in {looked}."
        fix = "Correct the name, or add its folder as an include folder (-I)."
        reading.findings.append(codes.INCLUDE_MISSING.finding(message, *origin.position, fix=fix))
    elif real in above:
        message = f"Include {include.target!r} forms a cycle: it leads back to a file that includes this one."
        reading.findings.append(codes.INCLUDE_CYCLE.finding(message, *origin.position, fix="Remove the include."))
    elif not _is_inside(real.parent, reading):
        message = f"Include {include.target!r} is outside of the folders that may be read."
        fix = "Add its folder as an include folder (-I)."
        reading.findings.append(codes.INCLUDE_OUTSIDE.finding(message, *origin.position, fix=fix))
    elif len(above) * len(reading.statements) > reading.limits.values or _too_many(reading):
        if not any(finding.rule == codes.INCLUDES_MULTIPLY.id for finding in reading.findings):
            message = "Includes multiply: the limit of included files and statements is reached."
            reading.findings.append(codes.INCLUDES_MULTIPLY.finding(message, *origin.position))
    else:
        found = _read_file(target, reading, origin)
        if found is not None:
            yield found, target


def _real(path: Path, reading: _Reading) -> Path:
    """`path` with links resolved; the file system is asked once for each folder and file."""
    known = reading.real_paths.get(path)
    if known is None:
        is_plain = path.name not in ("", "..") and not path.is_symlink()
        known = _real(path.parent, reading) / path.name if is_plain else real_path(path)
        reading.real_paths[path] = known
    return known


def _is_inside(folder: Path, reading: _Reading) -> bool:
    """Whether a folder, its links resolved, may be read: it is one of those allowed, or below one."""
    if folder not in reading.is_inside:
        reading.is_inside[folder] = any(allowed == folder or allowed in folder.parents for allowed in reading.allowed)
    return reading.is_inside[folder]


def _too_many(reading: _Reading) -> bool:
    return len(reading.files) > reading.limits.files or len(reading.statements) > reading.limits.nodes


def _find(target: str, folders: Sequence[Path]) -> Path | None:
    names = [target] if Path(target).suffix else [target + suffix for suffix in TREE_ENDINGS]
    for folder in dict.fromkeys(folders):
        for name in names:
            candidate = folder / name
            try:
                if candidate.exists():
                    return _without_steps_up(candidate) if ".." in target else candidate
            except (OSError, ValueError):  # a name too long or with a zero byte
                return None
    return None


def _without_steps_up(path: Path) -> Path:
    """The path without `..`, so that a file has one name; unchanged if links make that another file."""
    plain = Path(os.path.normpath(path))
    return plain if plain.exists() and plain.samefile(path) else path


def _read_file(path: Path, reading: _Reading, asked_at: Origin) -> VspecFile | None:
    """The file at a path, or nothing and a finding at what asked for it."""
    if path in reading.files:
        return reading.files[path]
    try:
        data, size = _bytes_of(path, reading.limits)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or str(error)
        message = f"{str(path)!r} cannot be read: {reason}."
        reading.findings.append(codes.FILE_UNREADABLE.finding(message, *asked_at.position))
        return None
    if data is None:
        message = f"The file has {size:,} bytes; the limit is {reading.limits.file_bytes:,}."
        reading.findings.append(codes.FILE_TOO_LARGE.finding(message, str(path)))
        return None
    overlay = reading.name if reading.is_overlay else ""
    source = SourceFile(str(path), overlay, digest_of(data))
    file = made_once(
        ("vspec", source.name, overlay),
        (source.digest, reading.limits),
        lambda: compiled_file(source, reading.compiled) or parse_vspec(data, source, reading.limits),
    )
    reading.files[path] = file
    return file


def _bytes_of(path: Path, limits: Limits) -> tuple[bytes | None, int]:
    """The bytes of a file, None beyond the limit, and its size. Raises OSError."""
    text = open_text(path)
    if text is not None:
        return text if len(text) <= limits.file_bytes else None, len(text)
    status = path.stat()
    if not stat.S_ISREG(status.st_mode):
        raise OSError(errno.EINVAL, "it is not a file")  # a pipe would be waited for
    return path.read_bytes() if status.st_size <= limits.file_bytes else None, status.st_size
