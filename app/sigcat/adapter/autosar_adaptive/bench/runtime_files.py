"""The runtime, which travels with the package: headers and sources in C++."""

from functools import cache
from pathlib import Path

from sigcat.adapter.files import GeneratedFile

_RUNTIME = Path(__file__).parent / "runtime"


@cache
def runtime_files() -> tuple[GeneratedFile, ...]:
    """All its files, by their paths below its folder."""
    found = sorted(path for path in _RUNTIME.rglob("*") if path.is_file())
    return tuple(GeneratedFile(path.relative_to(_RUNTIME).as_posix(), path.read_bytes()) for path in found)
