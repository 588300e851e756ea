"""Distributions of durations: figures of thousands of durations that a report can keep and show."""

import math
from collections.abc import Iterable, Sequence
from typing import NamedTuple

BINS_PER_DECADE = 12
"""Resolution of a histogram on a logarithmic axis."""
_SHORTEST = 10.0
"""In ns: what is shorter counts as this."""


class Distribution(NamedTuple):
    """Durations in ns."""

    total: int
    least: float
    p50: float
    p99: float
    worst: float
    first_bin: int
    """Bin `n` begins at `10 ** (n / BINS_PER_DECADE)` ns."""
    bins: tuple[int, ...]
    """Number of durations in each bin, from the first one on."""


def distribution(durations: Iterable[float]) -> Distribution | None:
    """Return the distribution of durations in ns; None if there are none."""
    ordered = sorted(durations)
    if not ordered:
        return None
    places = [math.floor(math.log10(max(each, _SHORTEST)) * BINS_PER_DECADE) for each in ordered]
    first = places[0]
    bins = [0] * (places[-1] - first + 1)
    for place in places:
        bins[place - first] += 1
    p50, p99 = quantile(ordered, 0.5), quantile(ordered, 0.99)
    return Distribution(len(ordered), ordered[0], p50, p99, ordered[-1], first, tuple(bins))


def quantile(ordered: Sequence[float], share: float) -> float:
    """The smallest of sorted values that so many of them do not exceed (nearest rank)."""
    return ordered[max(0, math.ceil(share * len(ordered)) - 1)]
