"""A normalized trace, which players and the test RTE read: cells separated by tabs, without quotes and JSON, and times in ns.

A trace may spell a value in several ways. Its one spelling is decided here: readers split lines at tabs, and cells at semicolons.
"""

from collections.abc import Iterable, Iterator, Mapping

from sigcat.runs.recording.cells import plain_text
from sigcat.runs.recording.trace_file import Trace
from sigcat.runs.recording.traces import moments

TIME_NS = "time_ns"
"""The first column. A trace has another one, so that no reader takes seconds for nanoseconds."""
CODE = ":e2e"
"""End of the name of a column with codes of end-to-end protection. It is before the column of the values."""


def normalized_lines(trace: Trace, names: Mapping[str, str]) -> Iterator[str]:
    """Yield the lines of a trace. `names` has the columns to write, by their names in the trace.

    Raises InputRefused at the end, with all errors in the trace.
    """
    shapes = {name: shape for name, shape in zip(trace.columns, trace.shapes, strict=True) if shape and name in names}
    columns = _columns([names[name] for name in shapes])
    yield normalized_line(TIME_NS, columns)
    for moment in moments(trace):
        cells = dict.fromkeys(columns, "")
        cells.update(
            (names[name], plain_text(value, shapes[name])) for name, value in moment.values if name in shapes
        )  # fmt: skip
        yield normalized_line(moment.time, cells.values())


def normalized_line(time: int | str, cells: Iterable[str]) -> str:
    """A row, or the header."""
    return "\t".join((str(time), *cells)) + "\n"


def _columns(names: Iterable[str]) -> tuple[str, ...]:
    """Names in order; the column of a code is followed by that of its values, also if the trace has none."""
    given = dict.fromkeys(names)
    signals = dict.fromkeys(name.removesuffix(CODE) for name in given)
    return tuple(each for name in signals for each in (f"{name}{CODE}", name) if each in given or each == name)
