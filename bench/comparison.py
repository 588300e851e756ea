"""Two recordings of a drive of ten minutes: read and compared bit by bit, next to reading the rows of their file."""

import csv
from collections.abc import Callable, Mapping
from pathlib import Path
from time import process_time

from bench.measuring import interleaved
from bench.rows import Bench, Row, at_most
from sigcat.adapter.host.shapes import Number
from sigcat.comparison.behaviour import in_lock_step
from sigcat.comparison.running.recorded import read_recorded

_STEPS = 12_000
"""Cycle of 50 ms."""
_OUTPUTS = {f"Vehicle.Output{number}": Number("float") for number in range(6)}


def compared(bench: Bench) -> Row:
    """Evaluate a recording as a comparison does for each platform; by processor time."""
    file = _recorded(bench.folder / "recorded.csv")
    expected = read_recorded(file, _OUTPUTS)

    def ours() -> float:
        start = process_time()
        assert in_lock_step(expected, read_recorded(file, _OUTPUTS)).values == _STEPS * len(_OUTPUTS)
        return process_time() - start

    def reference() -> float:
        start = process_time()
        with file.open(encoding="utf-8", newline="") as lines:
            assert len(list(csv.DictReader(lines))) == _STEPS * len(_OUTPUTS)
        return process_time() - start

    figure, beside = interleaved([ours, reference], bench.runs)
    work = "read a recording of ten minutes, 72,000 values, and compare it with another one"
    return at_most(work, figure, "`csv.DictReader` of the same file", beside, 4)


def _recorded(file: Path) -> Path:
    rows = (
        f'{step * 50_000_000},{name},"{step / (number + 3):.6g}"\n'
        for step in range(_STEPS)
        for number, name in enumerate(_OUTPUTS)
    )
    with file.open("w", encoding="utf-8") as out:
        out.writelines(["time,name,value\n", *rows])
    return file


ROWS: Mapping[str, Callable[[Bench], Row]] = {"compare": compared}
