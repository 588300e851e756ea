"""The gateway: EcoControl's drive on CAN to rows of a trace, beside python-can and cantools, which read and decode the same frames."""

from collections.abc import Callable, Mapping
from statistics import median
from time import process_time
from typing import Any

from bench.rows import Bench, Row
from sigcat.catalogue.hosting.source import load
from sigcat.catalogue.hosting.sources import shipped_sources
from sigcat.data import EXAMPLES
from sigcat.gateway.logs.read import read_log
from sigcat.gateway.prepare import prepare
from sigcat.gateway.trace import lines_of, rows_of
from sigcat.gateway.translation import Translation

_CAN = EXAMPLES / "ecocontrol/can"
_LOG = _CAN / "drive.log.gz"


def frames(bench: Bench) -> Row:
    """Log to trace: read, decode, convert and write, all of it in one process; by its time of the processor."""
    source = shipped_sources()[0]
    catalogue = load(source._replace(overlays=(*source.overlays, _CAN / "can.vspec")))
    prepared = prepare(catalogue, [_CAN / "ecocontrol.dbc"])

    def rate() -> float:
        translation = Translation(prepared.database, prepared.mapped)
        start = process_time()
        moments = translation.moments(read_log(_LOG, []), "drive")
        count = sum(1 for _ in lines_of(rows_of(moments), [each.name for each in prepared.mapped]))
        assert count > translation.counts.frames // 2
        return translation.counts.frames / (process_time() - start)

    figure, reference = median(rate() for _ in range(bench.runs)), median(_decoded_alone() for _ in range(bench.runs))
    work = "`sigcat gateway`: frames of a log, decoded, mapped and written"
    return Row(
        work, f"{figure:,.0f}/s", f"python-can and cantools, decoded alone: {reference:,.0f}/s",
        f"{figure / reference:.2f} ×", "at least 0.5 ×", figure / reference >= 0.5,
    )  # fmt: skip


def _decoded_alone() -> float:
    """Frames a second that python-can reads and cantools decodes, without a mapping and without writing."""
    import can
    import cantools

    database: Any = cantools.database.load_file(_CAN / "ecocontrol.dbc")
    known = {message.frame_id for message in database.messages}
    count, start = 0, process_time()
    with can.LogReader(_LOG) as log:
        for message in log:
            if message.arbitration_id in known:
                database.decode_message(message.arbitration_id, message.data)
            count += 1
    return count / (process_time() - start)


ROWS: Mapping[str, Callable[[Bench], Row]] = {"gateway": frames}
