"""Growth of the cost of work with its input. No test has a bound in seconds: machines differ, and have other work too."""

from collections.abc import Callable
from statistics import median
from time import process_time

LINEAR = 30
"""Bound on the growth for ten times as much: linear work has about 10, work that compares each with each 100."""

Work = Callable[[], object]


def growth(of: Callable[[int], Work], count: int, times: int = 10) -> float:
    """Ratio of the time for `times` as much work: the median of three pairs that are measured in turn.

    `of` prepares for a count, and gives the work whose seconds of the processor count. Where two pairs stay within the bound,
    so does the median, and the third is omitted.
    """
    small, large = of(count), of(times * count)
    pairs = [ratio(large, small), ratio(large, small)]
    return max(pairs) if max(pairs) < LINEAR else median([*pairs, ratio(large, small)])


def ratio(work: Work, reference: Work) -> float:
    """Ratio of the time of the work to that of the reference, each once."""
    return seconds(work) / max(seconds(reference), 0.0001)


def seconds(work: Work) -> float:
    """Seconds of the processor that this process spends on the work."""
    start = process_time()
    work()
    return process_time() - start
