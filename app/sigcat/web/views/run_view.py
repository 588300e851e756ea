"""A stored run of a function: what its page shows. It is made in a worker, since any file may be in a folder."""

from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from sigcat.adapter.host.shapes import Number
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.function.hosted_runs import HostedRun, HostedRuns, beside_runs, run_named
from sigcat.limits import RUN_SIGNALS, RUN_STATUSES
from sigcat.runs.columns import Column, FunctionColumns, columns_of
from sigcat.runs.recording.picture import Picture, picture
from sigcat.runs.recording.samples import Sample
from sigcat.runs.recording.series import ALWAYS, Series, Span
from sigcat.runs.recording.times import NANOSECONDS, nanoseconds
from sigcat.runs.stored_run import CallTimes, StoredRun, read_run
from sigcat.web.pictures.run_lanes import Bar, Lanes, gap_bars, run_lanes
from sigcat.web.run_words import seconds_text, word_of
from sigcat.web.template_filters import number

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
    limits: str
    """Range that the function declares, and its time-out."""
    passed: int
    """Pauses that were longer than the time-out."""


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


class Asked(NamedTuple):
    """A run, and the part of it that a page shows."""

    run: HostedRun
    others: HostedRuns = ()
    """Recordings that belong to the function, too."""
    signals: tuple[str, ...] = ()
    beside: str = ""
    """Id of a recording that is drawn over the run."""
    start: str = ""
    end: str = ""
    """Times of the window, in seconds."""
    with_lines: bool = False


class Zoom(NamedTuple):
    """A link to another window of the picture."""

    title: str
    start: str
    end: str
    is_other: bool
    """Whether it differs from the window that is shown."""


class Line(NamedTuple):
    """Values of a signal within the window, and of the other recording beside them."""

    name: str
    unit: str
    points: tuple[tuple[float, str], ...]
    """(seconds, word)"""
    beside: tuple[tuple[float, str], ...]


class RunView(NamedTuple):
    """All of it. Without a picture the notes say why."""

    choices: tuple[Choice, ...]
    others: tuple[str, ...]
    """Columns of the function that are not single numbers, and so not drawn."""
    notes: tuple[str, ...]
    findings: tuple[Finding, ...] = ()
    rows: int = 0
    lasts: str = ""
    start: str = ""
    end: str = ""
    """Ends of the axis of time, in seconds."""
    zooms: tuple[Zoom, ...] = ()
    drawn: Picture | None = None
    lanes: Lanes | None = None
    gaps: tuple[tuple[Bar, ...], ...] = ()
    """Passed time-outs of each signal that is drawn."""
    values: tuple[Values, ...] = ()
    statuses: tuple[Status, ...] = ()
    calls: tuple[Calls, ...] = ()
    comparable: HostedRuns = ()
    """Recordings that can be drawn over the run."""
    beside: HostedRun | None = None
    inputs: HostedRun | None = None
    """The recording with what the functions of the run received."""
    lines: tuple[Line, ...] = ()


class _Read(NamedTuple):
    """The recordings of a view, as far as they were read."""

    run: StoredRun
    inputs: StoredRun | None
    beside: StoredRun | None
    window: Span

    @property
    def series(self) -> Mapping[str, Series]:
        """Series of the run, and of the inputs that it does not have."""
        return {**(self.inputs.series if self.inputs else {}), **self.run.series}


def run_view(function: ResolvedFunction, asked: Asked) -> RunView:
    """A run of a function, with the requested signals; without any, the first ones that it sends."""
    try:
        of_function = columns_of(function)
    except InputRefused as refused:
        return RunView((), (), (f"The function has no adapter whose run could be shown: {refused}",))
    run, inputs = asked.run, _inputs_of(asked, of_function.columns)
    recorded = {*run.columns, *(inputs.columns if inputs else ())}
    there = {name: column for name, column in of_function.columns.items() if name in recorded}
    signals = [name for name, each in there.items() if each.kind == "signal" and isinstance(each.shape, Number)]
    statuses = [name for name, each in there.items() if each.kind != "signal"]
    known = list(dict.fromkeys(name for name in asked.signals if name in signals))
    shown = (known or [name for name in signals if there[name].is_sent][:_FIRST])[:RUN_SIGNALS]
    comparable = beside_runs(run.group, set(run.columns) & there.keys(), asked.others)
    view = RunView(
        tuple(Choice(name, there[name].is_sent, name in shown) for name in signals),
        tuple(name for name, each in there.items() if each.kind == "signal" and name not in signals),
        tuple(_notes(of_function.columns, asked, known, statuses)),
        comparable=comparable,
        beside=run_named(asked.beside, comparable) if asked.beside else None,
        inputs=inputs,
    )
    try:
        read = _read(view, asked, [*shown, *statuses[:RUN_STATUSES]], of_function)
    except InputRefused as refused:
        return view._replace(notes=(*view.notes, str(refused)), findings=tuple(refused.findings))
    except OSError as error:
        return view._replace(notes=(*view.notes, f"The file cannot be read: {error.strerror or 'it is gone'}."))
    return _with(view, read, asked, {name: there[name] for name in (*shown, *statuses) if name in read.series})


def _inputs_of(asked: Asked, columns: Mapping[str, Column]) -> HostedRun | None:
    """The trace in the folder of the run that has what the function receives, and nothing that the run has."""
    received = {name for name, column in columns.items() if not column.is_sent} - set(asked.run.columns)
    beside = (each for each in asked.others if not each.is_run and each.path.parent == asked.run.path.parent)
    sent = {name for name, column in columns.items() if column.is_sent and column.is_shared}
    return next((each for each in beside if received & set(each.columns) and not sent & set(each.columns)), None)


def _read(view: RunView, asked: Asked, wanted: Sequence[str], function: FunctionColumns) -> _Read:
    """Read the run, then of the others what is in its time. Raises InputRefused and OSError."""
    window = _window(asked) or ALWAYS
    in_run, columns = set(asked.run.columns), function.columns
    run = read_run(asked.run.path, asked.run.name, [each for each in wanted if each in in_run], function, window)
    inside = (max(window[0], run.first), min(window[1], run.last))
    if inside[0] > inside[1]:
        raise InputRefused(f"The run has no row from {asked.start or 0} s to {asked.end or seconds_text(run.last)} s.")
    received = [each for each in wanted if each not in in_run and not columns[each].is_sent]
    inputs = _beside(view.inputs, received, function, inside) if received else None
    compared = [each for each in wanted if columns[each].kind == "signal"]
    return _Read(run, inputs, _beside(view.beside, compared, function, inside), inside)


def _beside(
    other: HostedRun | None, wanted: Sequence[str], function: FunctionColumns, window: Span
) -> StoredRun | None:
    """Another recording, if there is one. Raises InputRefused and OSError."""
    if other is None:
        return None
    known = [each for each in wanted if each in other.columns]
    return read_run(other.path, other.name, known, function, window, is_run=other.is_run)


def _window(asked: Asked) -> Span | None:
    """The times of the address; None if they are not a window."""
    start, end = (
        nanoseconds(text) if text else otherwise
        for text, otherwise in zip((asked.start, asked.end), ALWAYS, strict=True)
    )
    return (start, end) if start is not None and end is not None and start < end else None


def _notes(columns: Mapping[str, Column], asked: Asked, known: Sequence[str], statuses: Sequence[str]) -> Iterable[str]:
    if _window(asked) is None:
        yield "`from` and `to` must be times in seconds, the first one earlier: the whole run is shown."
    missing = [name for name, column in columns.items() if column.is_sent and name not in asked.run.columns]
    if missing:
        yield f"The run is of another state of the function: it has no {_some(missing)}."
    unknown = [name for name in asked.signals if name not in known]
    if unknown:
        yield f"The run has no signal {_some(unknown)} that could be drawn."
    if len(known) > RUN_SIGNALS:
        yield f"A picture has at most {RUN_SIGNALS} signals: the first ones are shown."
    if len(statuses) > RUN_STATUSES:
        yield f"Of {len(statuses)} errors, safety reactions and modes the first {RUN_STATUSES} are shown."


def _some(names: Sequence[str]) -> str:
    shown = [f"`{name[:200]}`" for name in names[:3]]
    return ", ".join(shown) + (f" and {len(names) - 3} more" if len(names) > 3 else "")


def _with(view: RunView, read: _Read, asked: Asked, columns: Mapping[str, Column]) -> RunView:
    """The view with what was read."""
    pairs = [(column, read.series[name]) for name, column in columns.items()]
    signals = [(column, series) for column, series in pairs if column.kind == "signal"]
    statuses = [(column, series) for column, series in pairs if column.kind != "signal"]
    drawn = _drawn(signals, read)
    found = [
        *read.run.findings,
        *(read.inputs.findings if read.inputs else ()),
        *(read.beside.findings if read.beside else ()),
    ]
    return view._replace(
        notes=(*view.notes, *(() if read.run.rows else ("The run has no rows.",))),
        findings=tuple(found[:_FINDINGS]),
        rows=read.run.rows,
        lasts=seconds_text(read.run.last - read.run.first),
        start=seconds_text(round(drawn.first)),
        end=seconds_text(round(drawn.last)),
        zooms=tuple(_zooms(read)),
        drawn=drawn if pairs else None,
        lanes=run_lanes(drawn, statuses),
        gaps=tuple(gap_bars(series, column.timeout, drawn) if column.timeout else () for column, series in signals),
        values=tuple(_values(column, series) for column, series in signals),
        statuses=tuple(_status(column, series) for column, series in statuses),
        calls=tuple(map(_calls, read.run.calls)),
        lines=tuple(_line(column, series, read.beside) for column, series in signals) if asked.with_lines else (),
    )


def _drawn(signals: Sequence[tuple[Column, Series]], read: _Read) -> Picture:
    samples = [Sample(time, column.name, value) for column, series in signals for time, value in series.points]
    ends = [Sample(time, "", 0) for time in read.window]
    shapes = {column.name: column.shape for column, _ in signals}
    units = {column.name: column.unit for column, _ in signals}
    limits = {column.name: column.limits for column, _ in signals}
    beside = {name: series.points for name, series in read.beside.series.items()} if read.beside else {}
    return picture(list(shapes), shapes, units, [ends[0], *samples, ends[1]], beside, limits)


def _zooms(read: _Read) -> Iterable[Zoom]:
    """Half and twice the window, its neighbours, and the whole run."""
    (start, end), (first, last) = read.window, (read.run.first, read.run.last)
    half, quarter = (end - start) // 2, (end - start) // 4
    for title, low, high in (
        ("Zoom in", start + quarter, end - quarter),
        ("Zoom out", start - half, end + half),
        ("Earlier", max(start - half, first), max(start - half, first) + end - start),
        ("Later", min(end + half, last) - (end - start), min(end + half, last)),
        ("Whole run", first, last),
    ):
        shown = (max(low, first), min(high, last))
        is_whole = shown == (first, last)
        ends = ("", "") if is_whole else (seconds_text(shown[0]), seconds_text(shown[1]))
        yield Zoom(title, *ends, shown != read.window and shown[0] < shown[1])


def _line(column: Column, series: Series, beside: StoredRun | None) -> Line:
    other = beside.series.get(column.name) if beside else None
    return Line(column.name, column.unit, _written(series, column), _written(other, column) if other else ())


def _written(series: Series, column: Column) -> tuple[tuple[float, str], ...]:
    return tuple((time / NANOSECONDS, word_of(value, column.shape)) for time, value in series.points)


def _values(column: Column, series: Series) -> Values:
    first, last = word_of(series.first, column.shape), word_of(series.last, column.shape)
    least, greatest = (word_of(value, column.shape) for value in (series.least, series.greatest))
    limits, passed = ", ".join(_declared(column)), series.gap_total
    return Values(column.name, column.unit, series.total, first, least, greatest, last, limits, passed)


def _declared(column: Column) -> Iterable[str]:
    """The range and the time-out that the function declares."""
    if len(column.limits) == 2:
        yield " to ".join(number(float(f"{each:.6g}")) for each in column.limits)
    if column.timeout:
        yield f"time-out {seconds_text(column.timeout)} s"


def _status(column: Column, series: Series) -> Status:
    changes = tuple((seconds_text(time), word_of(value, column.shape)) for time, value in series.changes)
    return Status(column.name, column.kind, column.is_sent, changes, series.change_total - len(changes))


def _calls(each: CallTimes) -> Calls:
    longest = seconds_text(each.longest) if each.total > 1 else ""
    since = seconds_text(each.longest_from)
    return Calls(each.name, each.total, seconds_text(each.first), seconds_text(each.last), longest, since)
