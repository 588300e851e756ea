"""The runtime, which travels with the package: headers and sources in C++."""

from functools import cache
from pathlib import Path

from sigcat.adapter.files import GeneratedFile, shipped


@cache
def runtime_files() -> tuple[GeneratedFile, ...]:
    """All its files, by their paths below its folder."""
    return shipped(Path(__file__).parent / "runtime")
