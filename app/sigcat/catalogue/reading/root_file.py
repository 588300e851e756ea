"""Find the tree in a folder: the vspec file that a reader would start with."""

import os
from collections.abc import Iterator
from pathlib import Path, PurePosixPath
from typing import NamedTuple

from sigcat.catalogue.reading.statement import SourceFile
from sigcat.catalogue.reading.vspec_file import VspecFile, parse_vspec
from sigcat.digest import digest_of
from sigcat.errors import UsageError
from sigcat.file_kind import ROOT_NAME, TYPES_NAME, holds_only_structs, holds_signal
from sigcat.limits import DEFAULT_LIMITS, Limits

_SHOWN = 5


def root_file(folder: Path, limits: Limits = DEFAULT_LIMITS) -> Path:
    """The root file of the tree in or below a folder. Files below a folder `overlays` do not count.

    It has the usual name and is the uppermost one, or no other file includes it, and it holds more than struct types.
    Raises UsageError if that is not exactly one file.
    """
    files = [file for file in sorted(_vspec_files(folder, limits)) if "overlays" not in _folders(file, folder)]
    usual = [file for file in files if file.name == ROOT_NAME]
    if usual:
        depth = min(len(file.parts) for file in usual)
        roots = [file for file in usual if len(file.parts) == depth]
    else:
        read = {file: _read(file, limits) for file in files}
        included = {target for source in read.values() for target in source.included}
        tops = [file for file in files if not _is_among(file.relative_to(folder).as_posix(), included)]
        trees = [file for file in tops if not read[file].is_of_types]
        roots = [file for file in trees if read[file].has_root] or trees
    if not roots:
        raise UsageError(f"{folder}: no tree found (no .vspec file that no other includes)")
    if len(roots) > 1:
        names = ", ".join(file.relative_to(folder).as_posix() for file in roots[:_SHOWN])
        more = ", …" if len(roots) > _SHOWN else ""
        raise UsageError(f"{folder}: there are several trees: {names}{more}. Name one of these files.")
    return roots[0]


def types_beside(root: Path, limits: Limits = DEFAULT_LIMITS) -> tuple[Path, ...]:
    """The files of struct types in the folder of a tree: they hold nothing else, and no other includes them.

    One of the usual name is the only one.
    """
    usual = root.with_name(TYPES_NAME)
    if usual.is_file():
        return (usual,)
    beside = [file for file in sorted(root.parent.glob("*.vspec")) if file != root and file.is_file()]
    read = {file: source for file in beside if (source := _read(file, limits)).is_of_types}
    included = {target for source in read.values() for target in source.included}
    return tuple(file for file in read if not _is_among(file.name, included))


def _folders(file: Path, folder: Path) -> tuple[str, ...]:
    return file.relative_to(folder).parts[:-1]


def _vspec_files(folder: Path, limits: Limits) -> Iterator[Path]:
    count = 0
    for above, folders, files in os.walk(folder):
        folders[:] = [name for name in folders if not name.startswith(".")]
        count += len(files)
        if count > limits.files:
            raise UsageError(f"{folder}: there are more than {limits.files:,} files. Name the root file of the tree.")
        yield from (Path(above, name) for name in files if name.endswith(".vspec"))


class _Content(NamedTuple):
    """Facts about each file that are needed to find the root."""

    included: tuple[str, ...]
    """Included names, without suffix and without steps up."""
    is_of_types: bool
    """Whether it holds struct types and nothing else."""
    has_root: bool
    """Whether it, or what it includes, may have a node without a branch above it; an overlay has none."""


def _read(file: Path, limits: Limits) -> _Content:
    if file.stat().st_size > limits.file_bytes:
        return _Content((), is_of_types=False, has_root=True)
    data = file.read_bytes()
    text = parse_vspec(data, SourceFile(str(file), "", digest_of(data)), limits)
    return _Content(
        tuple(_without_steps(include.target) for include in text.includes),
        is_of_types=holds_only_structs(data) or (not holds_signal(data) and _includes_structs(file, text)),
        has_root=bool(text.includes) or any("." not in statement.path for statement in text.statements),
    )


def _includes_structs(file: Path, text: VspecFile) -> bool:
    """Whether all that a file includes are struct types, as in VSS after 6.0."""
    included = [file.parent / include.target for include in text.includes]
    return bool(included) and all(path.is_file() and holds_only_structs(path.read_bytes()) for path in included)


def _without_steps(target: str) -> str:
    parts = [part for part in PurePosixPath(target).parts if part not in ("..", ".")]
    return "/".join(parts).removesuffix(".vspec")


def _is_among(file: str, targets: set[str]) -> bool:
    """Whether a target names the file or ends its path: includes are looked for in several folders."""
    parts = file.removesuffix(".vspec").split("/")
    return any("/".join(parts[start:]) in targets for start in range(len(parts)))
