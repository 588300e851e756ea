"""Comparisons beside the functions of a service: files that `sigcat compare` wrote, known by their name."""

from collections.abc import Iterable, Iterator, Sequence
from itertools import islice
from pathlib import Path
from typing import NamedTuple

from sigcat.errors import NotFound
from sigcat.function.hosted_runs import free_id
from sigcat.limits import RUNS
from sigcat.names import nearest

FILE = "comparison.json"


class HostedComparison(NamedTuple):
    """A stored comparison. It is read when a page shows it."""

    id: str
    """Name in addresses: that of its folder."""
    name: str
    """Name in notes."""
    path: Path


HostedComparisons = tuple[HostedComparison, ...]


def comparisons_among(paths: Iterable[Path], folder: Path) -> Iterator[HostedComparison]:
    """The comparisons among files below a folder."""
    for path in islice((path for path in paths if path.name == FILE), RUNS):
        below = path.relative_to(folder)
        yield HostedComparison(below.parent.name or folder.name, (Path(folder.name) / below).as_posix(), path)


def told_apart(comparisons: Iterable[HostedComparison]) -> HostedComparisons:
    """The operator's own before shipped ones, each id once."""
    known: dict[str, HostedComparison] = {}
    for each in comparisons:
        free = free_id(each.id, known)
        known[free] = each._replace(id=free)
    return tuple(known.values())


def comparison_named(comparison_id: str, comparisons: Sequence[HostedComparison]) -> HostedComparison:
    """A comparison by its id. Raises NotFound with the nearest ids."""
    known = {each.id: each for each in comparisons}
    if comparison_id not in known:
        raise NotFound(f"Unknown comparison {comparison_id[:100]!r}.", nearest(comparison_id[:100], known))
    return known[comparison_id]
