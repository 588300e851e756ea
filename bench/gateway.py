"""The gateway: EcoControl's drive on CAN to rows of a trace, beside the frames that a published feeder decodes in a process."""

from collections.abc import Callable, Mapping
from statistics import median
from time import process_time

from bench.rows import Bench, Row
from sigcat.catalogue.hosting.source import load
from sigcat.catalogue.hosting.sources import shipped_sources
from sigcat.data import EXAMPLES
from sigcat.gateway.logs.read import read_log
from sigcat.gateway.prepare import prepare
from sigcat.gateway.trace import lines_of, rows_of
from sigcat.gateway.translation import Translation

_CAN = EXAMPLES / "ecocontrol/can"
_REFERENCE = 9_900
"""Frames a second that a process in Python was measured to decode, without a mapping."""


def frames(bench: Bench) -> Row:
    """Log to trace: read, decode, convert and write, all of it in one process; by its time of the processor."""
    source = shipped_sources()[0]
    catalogue = load(source._replace(overlays=(*source.overlays, _CAN / "can.vspec")))
    prepared = prepare(catalogue, [_CAN / "ecocontrol.dbc"])

    def rate() -> float:
        translation = Translation(prepared.database, prepared.mapped)
        start = process_time()
        moments = translation.moments(read_log(_CAN / "drive.log.gz", []), "drive")
        count = sum(1 for _ in lines_of(rows_of(moments), [each.name for each in prepared.mapped]))
        assert count > translation.counts.frames // 2
        return translation.counts.frames / (process_time() - start)

    figure = median(rate() for _ in range(bench.runs))
    work = "`sigcat gateway`: frames of a log, decoded, mapped and written"
    return Row(
        work, f"{figure:,.0f}/s", f"decoded alone: {_REFERENCE:,}/s", f"{figure / _REFERENCE:.1f} ×", "at least 1 ×"
    )


ROWS: Mapping[str, Callable[[Bench], Row]] = {"gateway": frames}
