"""Include guards and includes of C++ files."""

import re
from collections.abc import Iterable, Sequence
from typing import NamedTuple


class Includes(NamedTuple):
    """Headers that a file includes: the standard library first, then everything else."""

    standard: Sequence[str]
    """With their brackets."""
    own: Sequence[str]


def includes(names: Iterable[str]) -> Includes:
    """Each header once, sorted. Those of the standard library are in brackets."""
    known = sorted(set(names))
    return Includes(
        [name for name in known if name.startswith("<")], [name for name in known if not name.startswith("<")]
    )


def guard(path: str) -> str:
    """The include guard of a header."""
    return re.sub(r"[^A-Za-z0-9]", "_", path).upper() + "_"
