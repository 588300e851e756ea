"""A run in one of its forms: CSV, MCAP, or a picture of some signals."""

from collections.abc import Iterator, Mapping, Sequence
from itertools import takewhile
from typing import NamedTuple

from sigcat.errors import UsageError
from sigcat.names import did_you_mean
from sigcat.runs.prepare import Prepared
from sigcat.runs.recording.csv_file import csv_text
from sigcat.runs.recording.mcap_file import mcap_bytes
from sigcat.runs.recording.picture import picture
from sigcat.runs.recording.samples import samples
from sigcat.runs.recording.shapes import SECONDS, Number, Shape
from sigcat.runs.recording.svg_file import svg_text
from sigcat.runs.recording.trace_file import Moment, Trace, moments
from sigcat.runs.simulate import Simulated

CSV, MCAP, SVG = ".csv", ".mcap", ".svg"
FORMS = (CSV, MCAP, SVG)
"""By the endings of files."""


class Signals(NamedTuple):
    """What a run received and sent."""

    shapes: Mapping[str, Shape]
    units: Mapping[str, str]


def signals_of(prepared: Prepared, trace: Trace | None) -> Signals:
    """The columns of a trace and those of what is sent; not how long calls take."""
    columns = zip(trace.columns, trace.shapes, strict=True) if trace else ()
    received = {name: shape for name, shape in columns if shape is not None and shape != SECONDS}
    return Signals({**received, **prepared.columns}, prepared.connections.units)


def check_plotted(names: Sequence[str], signals: Signals) -> None:
    """Raise UsageError if one of these cannot be drawn."""
    for name in names:
        if name not in signals.shapes:
            raise UsageError(f"the run has no {name!r}. {did_you_mean(name, signals.shapes)}".rstrip(". "))
        if not isinstance(signals.shapes[name], Number):
            raise UsageError(f"{name} cannot be drawn: it is not one number")


def written(form: str, simulated: Simulated, prepared: Prepared, trace: Trace | None, plotted: Sequence[str]) -> bytes:
    """The file of a form; `plotted` are the signals of a picture."""
    if form == CSV:
        return csv_text(simulated.rows, prepared.columns).encode()
    signals = signals_of(prepared, trace)
    received = _received(trace, simulated.end, signals)
    if form == MCAP:
        return mcap_bytes(received, simulated.rows, *signals)
    drawn = picture(plotted, *signals, samples(received, simulated.rows))
    return svg_text(drawn).encode()


def _received(trace: Trace | None, end: int, signals: Signals) -> Iterator[Moment]:
    """What the trace holds until the end of the run."""
    for moment in takewhile(lambda each: each.time <= end, moments(trace) if trace else ()):
        yield Moment(moment.time, tuple(each for each in moment.values if each[0] in signals.shapes))
