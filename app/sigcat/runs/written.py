"""Files of a run, written while it runs: CSV, MCAP, or a picture of some signals."""

import ctypes
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import BinaryIO, NamedTuple, Protocol

from sigcat.adapter.host.shapes import SECONDS, Number, Shape
from sigcat.errors import UsageError
from sigcat.names import did_you_mean, either, last_name
from sigcat.runs.converting.layout import ShapeTables, Unfit, csv_tables, mcap_tables
from sigcat.runs.converting.library import Writer
from sigcat.runs.prepare import Prepared
from sigcat.runs.recording.csv_file import csv_header, csv_lines
from sigcat.runs.recording.mcap_file import McapFile, call_text, check_mcap, message_text
from sigcat.runs.recording.picture import picture
from sigcat.runs.recording.samples import Sample
from sigcat.runs.recording.series import SeriesCollector
from sigcat.runs.recording.svg_file import svg_text
from sigcat.runs.recording.trace_file import Trace
from sigcat.runs.running.rows import Block, Received, Row, decoded
from sigcat.runs.simulate import layout_of, recorded

CSV, MCAP, SVG = ".csv", ".mcap", ".svg"
FORMS = (CSV, MCAP, SVG)
"""By the endings of files."""


class Signals(NamedTuple):
    """Values that a run received and sent."""

    shapes: Mapping[str, Shape]
    units: Mapping[str, str]


def signals_of(prepared: Prepared, trace: Trace | None) -> Signals:
    """The columns of a trace and those of sent values; not durations of calls."""
    columns = zip(trace.columns, trace.shapes, strict=True) if trace else ()
    received = {name: shape for name, shape in columns if shape is not None and shape != SECONDS}
    return Signals({**received, **prepared.columns}, prepared.connections.units)


def check_plotted(names: Sequence[str], signals: Signals) -> None:
    """Raise UsageError if one of these cannot be drawn."""
    for name in names:
        if name not in signals.shapes:
            near = did_you_mean(name, signals.shapes) or _with_last_name(name, signals)
            raise UsageError(f"the run has no {name!r}. {near}".rstrip(". "))
        if not isinstance(signals.shapes[name], Number):
            raise UsageError(f"{name} cannot be drawn: it is not one number")


def _with_last_name(name: str, signals: Signals) -> str:
    """The fix of a name that is only the end of others; else all names."""
    same = [each for each in signals.shapes if last_name(each).casefold() == name.casefold()]
    return f"Write {either(same)}." if same else f"It has {', '.join(signals.shapes)}."


class Form(Protocol):
    """A file that takes blocks of a run as they come."""

    def take(self, block: Block, library: ctypes.CDLL | None) -> None:
        """Write a block; the library, where there is one, converts it."""
        ...

    def finish(self) -> None:
        """Write the rest."""
        ...


def form_of(
    form: str, file: BinaryIO, prepared: Prepared, trace: Trace | None, plotted: Sequence[str]
) -> Form:  # fmt: skip
    """Return the writer of a form; `plotted` are the signals of a picture."""
    if form == CSV:
        return _Csv(file, prepared)
    signals = signals_of(prepared, trace)
    named = _names_of_entries(prepared, trace)
    return _Mcap(file, prepared, signals, named) if form == MCAP else _Svg(file, prepared, signals, named, plotted)


def echoes(forms: Sequence[str]) -> bool:
    """Whether a form has what is received, too."""
    return any(form != CSV for form in forms)


def _names_of_entries(prepared: Prepared, trace: Trace | None) -> Mapping[int, str]:
    """The columns of a trace by the first entry that gets their values."""
    names: dict[int, str] = {}
    for column in trace.columns if trace else ():
        entries = (number for number, entry in enumerate(prepared.connections.entries) if column in entry.names)
        number = next(entries, None)
        if number is not None:
            names.setdefault(number, column)
    return names


class _Csv:
    def __init__(self, file: BinaryIO, prepared: Prepared) -> None:
        self._file, self._prepared, self._layout = file, prepared, layout_of(prepared)
        self._fast = _Fast(self._tables)
        file.write(csv_header(prepared.columns).encode())

    def take(self, block: Block, library: ctypes.CDLL | None) -> None:
        at = self._fast.write(block.data, library, Writer.csv, self._file.write)
        if at < len(block.data):
            rows = decoded(Block(block.data[at:]), self._layout)
            named = (recorded(row, self._prepared) for row in rows if isinstance(row, Row))
            self._file.write("".join(csv_lines(named, self._prepared.columns)).encode())

    def finish(self) -> None:
        pass

    def _tables(self) -> ShapeTables:
        places = {name: place for place, name in enumerate(self._prepared.columns)}
        exits = [(each.shape, places[each.name]) for each in self._prepared.connections.exits]
        calls = [call.interface if call else "" for call in self._prepared.numbers.calls]
        return csv_tables(exits, [each.shape for each in self._prepared.connections.entries], calls, len(places))


class _Fast:
    """Writes blocks by the library, as far as it takes them."""

    def __init__(self, tables: Callable[[], ShapeTables]) -> None:
        self._tables = tables
        self._is_fit = True
        self.writer: Writer | None = None

    def write(self, data: bytes, library: ctypes.CDLL | None, how: "_How", put: Callable[[bytes], object]) -> int:
        """Write a block, or the first part of it. Where the rest begins, which is for Python."""
        at = 0
        writer = self._writer(library)
        while writer is not None and at < len(data):
            at, text, is_left = how(writer, data, at)
            put(text)
            if is_left:
                break
        return at

    def _writer(self, library: ctypes.CDLL | None) -> Writer | None:
        if self.writer is None and library is not None and self._is_fit:
            try:
                self.writer = Writer(library, self._tables())
            except Unfit:
                self._is_fit = False
        return self.writer


_How = Callable[[Writer, bytes, int], tuple[int, bytes, bool]]


class _Samples:
    """Values of blocks, received and sent, one by one."""

    def __init__(self, prepared: Prepared, signals: Signals, named: Mapping[int, str]) -> None:
        self._prepared, self._signals, self._named = prepared, signals, named
        self._layout = layout_of(prepared)

    def of(self, block: Block) -> Iterator[Sample]:
        """Samples; a call is one of its name, with its time."""
        for each in decoded(block, self._layout):
            if isinstance(each, Received):
                name = self._named.get(each.entry)
                if name is not None and name in self._signals.shapes:
                    yield Sample(each.time, name, each.value)
                continue
            row = recorded(each, self._prepared)
            yield from (Sample(row.time, name, value) for name, value in row.values)
            if row.call:
                yield Sample(row.time, row.call, row.time)


class _Mcap:
    def __init__(self, file: BinaryIO, prepared: Prepared, signals: Signals, named: Mapping[int, str]) -> None:
        check_mcap()
        self._prepared, self._named = prepared, named
        calls = {call.interface: None for call in prepared.numbers.calls if call}
        self._file = McapFile(file, {**signals.shapes, **calls}, signals.units)
        self._samples, self._shapes = _Samples(prepared, signals, named), signals.shapes
        self._fast = _Fast(self._tables)

    def take(self, block: Block, library: ctypes.CDLL | None) -> None:
        at = self._fast.write(block.data, library, Writer.mcap, self._file.add_records)
        if self._fast.writer is not None:
            self._file.indexes = self._fast.writer.indexes
        for time, name, value in self._samples.of(Block(block.data[at:])):
            shape = self._shapes.get(name)
            self._file.add(name, time, message_text(value, shape) if shape else call_text(time))

    def finish(self) -> None:
        self._file.finish()

    def _tables(self) -> ShapeTables:
        channels, connections = self._file.channels, self._prepared.connections
        exits = [(each.shape, channels[each.name]) for each in connections.exits]
        named = (self._named.get(number, "") for number in range(len(connections.entries)))
        entries = [
            (each.shape, channels.get(name) if name in self._shapes else None)
            for each, name in zip(connections.entries, named, strict=True)
        ]
        names = [call.interface if call else "" for call in self._prepared.numbers.calls]
        return mcap_tables(exits, entries, [(name, channels.get(name)) for name in names])


class _Svg:
    def __init__(
        self, file: BinaryIO, prepared: Prepared, signals: Signals, named: Mapping[int, str], plotted: Sequence[str]
    ) -> None:
        self._file, self._signals = file, signals
        self._samples = _Samples(prepared, signals, named)
        self._series = {name: SeriesCollector() for name in plotted}
        self._ends: list[Sample] = []

    def take(self, block: Block, library: ctypes.CDLL | None) -> None:
        del library
        for time, name, value in self._samples.of(block):
            self._ends = [*self._ends[:1], Sample(time, "", 0)]
            if name in self._series:
                self._series[name].add(time, float(value))

    def finish(self) -> None:
        points = [
            Sample(time, name, value) for name, each in self._series.items() for time, value in each.series.points
        ]
        drawn = picture(list(self._series), *self._signals, [*self._ends, *points])
        self._file.write(svg_text(drawn).encode())
