"""Write migrated files: all of them, or none."""

import os
import tempfile
from collections.abc import Iterable, Mapping
from pathlib import Path

from sigcat.errors import UsageError
from sigcat.real_path import real_path

_READABLE, _WRITABLE = 0o644, 0o222


def write_all(texts: Mapping[Path, bytes]) -> None:
    """Replace files, links followed. If one of them cannot be replaced, all keep what they had. Raises UsageError."""
    prepared: list[tuple[Path, Path]] = []
    replaced: dict[Path, bytes | None] = {}
    try:
        for path, data in texts.items():
            target = real_path(path)
            if target.exists() and not target.stat().st_mode & _WRITABLE:  # root may write all, and should not
                raise UsageError(
                    f"{path} is read-only: run `chmod u+w` on it, or name other files. No file was changed."
                )
            prepared.append((_written_beside(target, data), target))
        for new, target in prepared:
            replaced[target] = target.read_bytes() if target.exists() else None
            new.replace(target)
    except OSError as error:
        _restore(replaced)
        raise UsageError(f"{error.filename}: {error.strerror}. No file was changed.") from None
    finally:
        _remove(new for new, _ in prepared)


def _written_beside(target: Path, data: bytes) -> Path:
    """Write a new file next to the one that it replaces, with its permissions."""
    number, name = tempfile.mkstemp(prefix=f".{target.name}.", dir=target.parent)
    new = Path(name)
    with os.fdopen(number, "wb") as file:
        file.write(data)
    new.chmod(target.stat().st_mode if target.exists() else _READABLE)
    return new


def _restore(files: Mapping[Path, bytes | None]) -> None:
    for path, data in files.items():
        if data is None:
            path.unlink(missing_ok=True)
        else:
            path.write_bytes(data)


def _remove(files: Iterable[Path]) -> None:
    for path in files:
        path.unlink(missing_ok=True)
