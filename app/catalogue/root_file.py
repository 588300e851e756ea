"""Find the tree in a folder: the vspec file that a reader would start with."""

import hashlib
import os
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

from app.catalogue.limits import DEFAULT_LIMITS, Limits
from app.catalogue.vspec_file import SourceFile, parse_vspec
from app.errors import UsageError

_USUAL_NAME = "VehicleSignalSpecification.vspec"
_SHOWN = 5


def root_file(folder: Path, limits: Limits = DEFAULT_LIMITS) -> Path:
    """The root file of the tree in or below a folder. Files below a folder `overlays` are none.

    It has the usual name and stands highest, or no other file includes it. Raises UsageError where that is not one.
    """
    files = [file for file in sorted(_vspec_files(folder, limits)) if "overlays" not in _folders(file, folder)]
    usual = [file for file in files if file.name == _USUAL_NAME]
    if usual:
        depth = min(len(file.parts) for file in usual)
        roots = [file for file in usual if len(file.parts) == depth]
    else:
        included = {target for file in files for target in _included(file, limits)}
        roots = [file for file in files if not _is_among(file.relative_to(folder).as_posix(), included)]
    if not roots:
        raise UsageError(f"{folder}: there is no tree (no .vspec file that no other includes)")
    if len(roots) > 1:
        names = ", ".join(file.relative_to(folder).as_posix() for file in roots[:_SHOWN])
        more = ", …" if len(roots) > _SHOWN else ""
        raise UsageError(f"{folder}: there are several trees: {names}{more}. Name one of these files.")
    return roots[0]


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


def _included(file: Path, limits: Limits) -> Iterator[str]:
    """What a file includes, without suffix and without steps up."""
    if file.stat().st_size > limits.file_bytes:
        return
    data = file.read_bytes()
    source = SourceFile(str(file), "", hashlib.sha256(data).hexdigest())
    for include in parse_vspec(data, source, limits).includes:
        parts = [part for part in PurePosixPath(include.target).parts if part not in ("..", ".")]
        yield "/".join(parts).removesuffix(".vspec")


def _is_among(file: str, targets: set[str]) -> bool:
    """Whether a target names the file or ends its path: includes are looked for in several folders."""
    parts = file.removesuffix(".vspec").split("/")
    return any("/".join(parts[start:]) in targets for start in range(len(parts)))
