"""A stored run of a function: what its page shows. It is made in a worker, since any file may be in a folder."""

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.host.shapes import Number
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.hosted_runs import HostedRun
from sigcat.limits import RUN_SIGNALS, RUN_STATUSES
from sigcat.runs.columns import Column, columns_of
from sigcat.runs.recording.picture import Picture, picture
from sigcat.runs.recording.samples import Sample
from sigcat.runs.recording.series import Series
from sigcat.runs.stored_run import CallTimes, StoredRun, read_run
from sigcat.web.pictures.run_lanes import Lanes, run_lanes
from sigcat.web.run_words import seconds_text, word_of

_FIRST = 4
"""Signals that are shown before one chooses."""
_FINDINGS = 10


class Choice(NamedTuple):
    """A signal that can be drawn."""

    name: str
    is_sent: bool
    is_shown: bool


class Values(NamedTuple):
    """A signal as text."""

    name: str
    unit: str
    total: int
    first: str
    least: str
    greatest: str
    last: str


class Status(NamedTuple):
    """An error, a safety reaction or a mode as text: its values, and since when."""

    name: str
    kind: str
    is_sent: bool
    changes: tuple[tuple[str, str], ...]
    """(seconds, word)"""
    further: int
    """Changes that are not listed."""


class Calls(NamedTuple):
    """A call as text. Times are in seconds."""

    name: str
    total: int
    first: str
    last: str
    longest: str
    """Longest time to the next one; empty if there was none."""
    longest_from: str


class RunView(NamedTuple):
    """All of it. Without a picture the notes say why."""

    choices: tuple[Choice, ...]
    others: tuple[str, ...]
    """Columns of the function that are not single numbers, and so not drawn."""
    notes: tuple[str, ...]
    findings: tuple[Finding, ...] = ()
    rows: int = 0
    lasts: str = ""
    drawn: Picture | None = None
    lanes: Lanes | None = None
    values: tuple[Values, ...] = ()
    statuses: tuple[Status, ...] = ()
    calls: tuple[Calls, ...] = ()


def run_view(function: ResolvedFunction, run: HostedRun, wanted: Sequence[str]) -> RunView:
    """A run of a function, with the requested signals; without any, the first ones that it sends."""
    try:
        of_function = columns_of(function)
    except InputRefused as refused:
        return RunView((), (), (f"The function has no adapter whose run could be shown: {refused}",))
    recorded = frozenset(run.columns)
    there = {name: column for name, column in of_function.columns.items() if name in recorded}
    signals = [name for name, each in there.items() if each.kind == "signal" and isinstance(each.shape, Number)]
    statuses = [name for name, each in there.items() if each.kind != "signal"]
    known = list(dict.fromkeys(name for name in wanted if name in signals))
    shown = (known or [name for name in signals if there[name].is_sent][:_FIRST])[:RUN_SIGNALS]
    view = RunView(
        tuple(Choice(name, there[name].is_sent, name in shown) for name in signals),
        tuple(name for name, each in there.items() if each.kind == "signal" and name not in signals),
        tuple(_notes(of_function.columns, there, wanted, known, statuses)),
    )
    try:
        read = read_run(run.path, run.name, [*shown, *statuses[:RUN_STATUSES]], of_function)
    except InputRefused as refused:
        return view._replace(notes=(*view.notes, str(refused)), findings=tuple(refused.findings))
    except OSError as error:
        return view._replace(notes=(*view.notes, f"The file cannot be read: {error.strerror or 'it is gone'}."))
    return _with(view, read, {name: there[name] for name in read.series})


def _notes(
    columns: Mapping[str, Column],
    there: Mapping[str, Column],
    wanted: Sequence[str],
    known: Sequence[str],
    statuses: Sequence[str],
) -> Iterable[str]:
    missing = [name for name, column in columns.items() if column.is_sent and name not in there]
    if missing:
        yield f"The run is of another state of the function: it has no {_some(missing)}."
    unknown = [name for name in wanted if name not in known]
    if unknown:
        yield f"The run has no signal {_some(unknown)} that could be drawn."
    if len(known) > RUN_SIGNALS:
        yield f"A picture has at most {RUN_SIGNALS} signals: the first ones are shown."
    if len(statuses) > RUN_STATUSES:
        yield f"Of {len(statuses)} errors, safety reactions and modes the first {RUN_STATUSES} are shown."


def _some(names: Sequence[str]) -> str:
    shown = [f"`{name[:200]}`" for name in names[:3]]
    return ", ".join(shown) + (f" and {len(names) - 3} more" if len(names) > 3 else "")


def _with(view: RunView, read: StoredRun, columns: Mapping[str, Column]) -> RunView:
    """The view with what was read."""
    signals = [(columns[name], series) for name, series in read.series.items() if columns[name].kind == "signal"]
    statuses = [(columns[name], series) for name, series in read.series.items() if columns[name].kind != "signal"]
    drawn = _drawn(signals, read)
    empty = () if read.rows else ("The run has no rows.",)
    return view._replace(
        notes=(*view.notes, *empty),
        findings=read.findings[:_FINDINGS],
        rows=read.rows,
        lasts=seconds_text(read.last - read.first),
        drawn=drawn if read.series else None,
        lanes=run_lanes(drawn, statuses),
        values=tuple(_values(column, series) for column, series in signals),
        statuses=tuple(_status(column, series) for column, series in statuses),
        calls=tuple(map(_calls, read.calls)),
    )


def _drawn(signals: Sequence[tuple[Column, Series]], read: StoredRun) -> Picture:
    samples = [Sample(time, column.name, value) for column, series in signals for time, value in series.points]
    ends = (Sample(read.first, "", 0), Sample(read.last, "", 0))
    shapes = {column.name: column.shape for column, _ in signals}
    units = {column.name: column.unit for column, _ in signals}
    return picture(list(shapes), shapes, units, [ends[0], *samples, ends[1]])


def _values(column: Column, series: Series) -> Values:
    first, last = word_of(series.first, column.shape), word_of(series.last, column.shape)
    least, greatest = (word_of(value, column.shape) for value in (series.least, series.greatest))
    return Values(column.name, column.unit, series.total, first, least, greatest, last)


def _status(column: Column, series: Series) -> Status:
    changes = tuple((seconds_text(time), word_of(value, column.shape)) for time, value in series.changes)
    return Status(column.name, column.kind, column.is_sent, changes, series.change_total - len(changes))


def _calls(each: CallTimes) -> Calls:
    longest = seconds_text(each.longest) if each.total > 1 else ""
    since = seconds_text(each.longest_from)
    return Calls(each.name, each.total, seconds_text(each.first), seconds_text(each.last), longest, since)
