"""Outputs, compared with expected ones as they come: a value holds until the next one, at each time that is expected."""

from collections import deque
from collections.abc import Iterator, Mapping
from itertools import groupby
from typing import NamedTuple

from sigcat.adapter.host.shapes import Number, Shape, Value, numbers, packing
from sigcat.runs.expecting.tolerances import Tolerance, Tolerances
from sigcat.runs.recording.trace_file import Moment, Trace, moments

_AROUND = 100
"""Values before and after the first difference that a picture shows."""

Point = tuple[int, Value]
"""A time in ns, and a value."""


class Difference(NamedTuple):
    """A value beside the expected one."""

    time: int
    line: int
    expected: Value
    actual: Value | None
    """None: nothing was sent until then."""
    has_ended: bool
    """Whether the run ended before."""


class Compared:
    """A column that is expected."""

    def __init__(self, name: str, shape: Shape, tolerance: Tolerance) -> None:
        self.name, self.shape = name, shape
        self.total = self.differing = 0
        self.first: Difference | None = None
        self.largest = 0.0
        """The largest difference of finite numbers."""
        self.expected: deque[Point] = deque(maxlen=_AROUND)
        self.actual: deque[Point] = deque(maxlen=_AROUND)
        self._after = 0
        self._packing, self._tolerance = packing(shape), tolerance

    def compare(self, one: Difference) -> None:
        """Compare a value with the one that holds then."""
        expected = self._packing.unpack(self._packing.pack(one.expected))
        self.total += 1
        self._keep(one.time, expected, one.actual)
        if not one.has_ended and one.actual is not None and self._is_near(expected, one.actual):
            return
        self.differing += 1
        if self.first is None:
            self.first = one._replace(expected=expected)
            self.expected, self.actual = (deque(each, 2 * _AROUND) for each in (self.expected, self.actual))

    def _keep(self, time: int, expected: Value, actual: Value | None) -> None:
        """Keep what a picture shows."""
        self._after += self.first is not None
        if isinstance(self.shape, Number) and self._after <= _AROUND:
            self.expected.append((time, expected))
            if actual is not None:
                self.actual.append((time, actual))

    def _is_near(self, expected: Value, actual: Value) -> bool:
        pairs = zip(numbers(expected, self.shape), numbers(actual, self.shape), strict=True)
        near = [self._is_number_near(one, other) for one, other in pairs]
        return all(near)

    def _is_number_near(self, expected: Value, actual: Value) -> bool:
        difference = abs(float(actual) - float(expected))
        if difference > self.largest and difference < float("inf"):
            self.largest = difference
        is_exact = isinstance(self.shape, Number) and (self.shape.symbols or self.shape.datatype == "boolean")
        return bool(expected == actual) if is_exact else self._tolerance.accepts(expected, actual)


class Expectation:
    """Compares rows, in order of time, with a file of expected outputs. Raises InputRefused where that is wrong."""

    def __init__(self, file: Trace, aliases: Mapping[str, str], allowed: Tolerances) -> None:
        """Aliases are the names of outputs in rows, by all of their names."""
        self._aliases = aliases
        named = ((column, shape) for column, shape in zip(file.columns, file.shapes, strict=True) if shape is not None)
        self.columns = {
            name: Compared(name, shape, allowed.of([name, aliases[name]])) for name, shape in named
        }  # fmt: skip
        self._moments = _merged(moments(file))
        self._next = next(self._moments, None)
        self._held: dict[str, Value] = {}
        self._time: int | None = None

    def take(self, time: int, name: str, value: Value) -> None:
        """Take a value that was sent; before, compare what was expected until its time."""
        if time != self._time:
            self._compare(time)
        self._time = time
        self._held[name] = value

    def end(self, time: int) -> None:
        """Compare the rest: the run ended at a time."""
        self._compare(time + 1)
        while self._next is not None:
            self._compare_one(self._next, has_ended=True)

    def _compare(self, until: int) -> None:
        while self._next is not None and self._next.time < until:
            self._compare_one(self._next, has_ended=False)

    def _compare_one(self, due: "_Time", *, has_ended: bool) -> None:
        for cell in due.cells:
            actual = self._held.get(self._aliases[cell.name])
            first = Difference(due.time, cell.line, cell.value, actual, has_ended)
            self.columns[cell.name].compare(first)
        self._next = next(self._moments, None)


class _Cell(NamedTuple):
    """An expected value."""

    name: str
    value: Value
    line: int


class _Time(NamedTuple):
    """Values that are expected at a time."""

    time: int
    cells: tuple[_Cell, ...]


def _merged(found: Iterator[Moment]) -> Iterator[_Time]:
    """Rows of one time as one: of several values of a column, the last one is expected."""
    for time, rows in groupby(found, key=lambda each: each.time):
        cells = {name: _Cell(name, value, row.line) for row in rows for name, value in row.values}
        yield _Time(time, tuple(cells.values()))
