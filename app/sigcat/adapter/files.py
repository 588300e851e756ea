"""What every adapter gives: files, by name and content. Writing them is left to the caller."""

from typing import NamedTuple


class GeneratedFile(NamedTuple):
    """One file; the name has forward slashes and no folder above it."""

    name: str
    data: bytes
