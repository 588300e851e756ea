"""Resources of the processes that serve, as one total, and memory of all processes of the service."""

import os
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from pathlib import Path

from prometheus_client.core import GaugeMetricFamily, Metric
from prometheus_client.multiprocess import mark_process_dead
from prometheus_client.process_collector import ProcessCollector
from prometheus_client.registry import Collector

_PROC = Path("/proc")
_EARLIEST = "process_start_time_seconds"
Processes = Callable[[], Iterable[int]]


def this_process() -> Iterable[int]:
    """The one process that serves."""
    return (os.getpid(),)


def workers_in(folder: Path) -> Iterator[int]:
    """The workers that keep metrics in a folder. The gauges of those that have ended are removed."""
    for process in sorted({int(file.stem.rpartition("_")[2]) for file in folder.glob("gauge_live*_*.db")}):
        try:
            os.kill(process, 0)
        except ProcessLookupError:
            mark_process_dead(process, str(folder))  # type: ignore[no-untyped-call]
        else:
            yield process


class ProcessTotals(Collector):
    """`process_*` of all processes that serve: sums, and the earliest start."""

    def __init__(self, processes: Processes) -> None:
        self._processes = processes

    def collect(self) -> Iterable[Metric]:
        """The families of Prometheus' own collector."""
        totals: dict[str, Metric] = {}
        for process in self._processes():
            for family in ProcessCollector(pid=lambda found=process: found, registry=None).collect():  # type: ignore[misc]
                _add(family, totals)
        return totals.values()


def _add(family: Metric, totals: dict[str, Metric]) -> None:
    known = totals.setdefault(family.name, family)
    if known is not family:
        (sample,), (other,) = known.samples, family.samples
        merge = min if family.name == _EARLIEST else sum
        known.samples = [sample._replace(value=merge((sample.value, other.value)))]


class MemoryTotal(Collector):
    """Memory of the service: of the processes that serve, of the fork servers and of all workers; Linux only."""

    def __init__(self, processes: Processes) -> None:
        self._processes = processes

    def collect(self) -> Iterable[Metric]:
        """One figure; what processes share is counted once."""
        family = GaugeMetricFamily("sigcat_memory_pss_bytes", "PSS of all processes of the service, in bytes.")
        if (_PROC / "self" / "smaps_rollup").exists():
            family.add_metric((), sum(map(_pss, family_of(self._processes()))))
        yield family


def family_of(processes: Iterable[int]) -> list[int]:
    """Processes and all below them, as they are now."""
    children: dict[int, list[int]] = {}
    for folder in _PROC.iterdir():
        if folder.name.isdecimal():
            with suppress(OSError):
                parent = int((folder / "stat").read_text().rpartition(")")[2].split()[1])
                children.setdefault(parent, []).append(int(folder.name))
    found = [*processes]
    for each in found:
        found += children.get(each, ())
    return found


def _pss(process: int) -> int:
    with suppress(OSError):
        for line in (_PROC / str(process) / "smaps_rollup").read_text().splitlines():
            if line.startswith("Pss:"):
                return int(line.split()[1]) * 1024
    return 0
