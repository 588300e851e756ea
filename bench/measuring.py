"""Take figures side by side: the ones to compare in turn, several times, and the median of each."""

import subprocess
import sys
from collections.abc import Callable, Collection, Sequence
from pathlib import Path
from statistics import median
from time import perf_counter

ROOT = Path(__file__).parent.parent
Measure = Callable[[], float]


def interleaved(measures: Sequence[Measure], runs: int) -> list[float]:
    """The median of each measure, taken in turn so that a busy machine is busy for all."""
    taken = [[measure() for measure in measures] for _ in range(runs)]
    return [median(values) for values in zip(*taken, strict=True)]


def probe(name: str, tree: Path) -> Measure:
    """A measure of `bench.probe`, in a fresh process each time."""
    command = [sys.executable, "-m", "bench.probe", name, str(tree)]
    return lambda: float(subprocess.run(command, cwd=ROOT, capture_output=True, check=True).stdout)


def command(*words: str, status: Collection[int] = (0,)) -> Measure:
    """Seconds from the start of a command to its end. Raises RuntimeError if it ends with another `status`."""

    def measure() -> float:
        start = perf_counter()
        ended = subprocess.run(words, cwd=ROOT, capture_output=True, check=False)
        seconds = perf_counter() - start
        if ended.returncode not in status:
            raise RuntimeError(f"{' '.join(words)} ended with {ended.returncode}: {ended.stderr.decode()[:500]}")
        return seconds

    return measure
