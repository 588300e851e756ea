"""The page of a stored run: ten minutes of CoreAcc, beside reading the rows of the same file."""

import csv
import shutil
from collections.abc import Callable, Mapping
from pathlib import Path
from time import perf_counter

from bench.measuring import interleaved
from bench.rows import Bench, Row, at_most
from sigcat.catalogue.hosting.library import Library
from sigcat.catalogue.hosting.sources import shipped_sources
from sigcat.data import EXAMPLES
from sigcat.function.hosting import FunctionLibrary, function_over
from sigcat.runs.recording.times import NANOSECONDS, nanoseconds, seconds
from sigcat.web.views.run_view import Asked, run_view

_MINUTES = 10


def run_page(bench: Bench) -> Row:
    """Do the work of a worker for the page: read the file, and place everything in a picture."""
    folder = bench.folder / "functions"
    shutil.copytree(EXAMPLES / "core_acc", folder / "core_acc")
    file = _ten_minutes(folder)
    functions = FunctionLibrary([folder], has_shipped=False)
    function = function_over(functions.files, Library(shipped_sources()).default.catalogue, "core_acc")
    assert function.resolved is not None
    resolved, (run,) = function.resolved, functions.runs_of(function)

    def ours() -> float:
        start = perf_counter()
        assert run_view(resolved, Asked(run)).drawn
        return perf_counter() - start

    def reference() -> float:
        start = perf_counter()
        with file.open(encoding="utf-8", newline="") as lines:
            assert list(csv.DictReader(lines))
        return perf_counter() - start

    work = "read and draw a stored run of ten minutes, 12,000 rows"
    return at_most(work, *_beside(interleaved([ours, reference], bench.runs)), 4)


def _beside(medians: list[float]) -> tuple[float, str, float]:
    figure, reference = medians
    return figure, "`csv.DictReader` of the same file", reference


def _ten_minutes(folder: Path) -> Path:
    """The shipped run of a minute, ten times one after the other."""
    header, *rows = (EXAMPLES / "ecocontrol" / "run.csv").read_text(encoding="utf-8").splitlines()
    split = [row.partition(",")[::2] for row in rows]
    lines = [
        f"{seconds((nanoseconds(time) or 0) + minute * 60 * NANOSECONDS)},{rest}"
        for minute in range(_MINUTES)
        for time, rest in split
    ]
    file = folder / "drive.csv"
    file.write_text("\n".join([header, *lines, ""]), encoding="utf-8")
    return file


ROWS: Mapping[str, Callable[[Bench], Row]] = {"run-page": run_page}
