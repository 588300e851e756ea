"""Behaviour of platforms, as a report tells it: outputs, free run, traces over each other, faults."""

import math
from collections.abc import Iterator, Mapping, Sequence

from sigcat.adapter.host.shapes import Number
from sigcat.comparison import behaviour
from sigcat.comparison.behaviour import at_points, in_free_run, in_lock_step
from sigcat.comparison.recording import Recording
from sigcat.comparison.report import model
from sigcat.comparison.telling.material import Material, PlayedFault
from sigcat.runs.columns import Column

_COLUMNS = 360
"""Columns of pixels of a picture: of each the first, the smallest, the largest and the last value are kept."""
_TRACES = 6


def behaviours(material: Material) -> Iterator[model.Behaviour]:
    """Each platform in lock step, beside the reference."""
    expected = material.reference.lock_step
    for each in material.platforms[1:]:
        if expected is not None and each.lock_step is not None:
            played = each.lock_step
            found = _compared(expected, played)
            yield model.Behaviour(
                platform=each.name,
                seconds=material.drive_seconds,
                steps=len(each.lock_step.calls),
                outputs=found.outputs,
            )


def _compared(expected: Recording, found: Recording) -> behaviour.Behaviour:
    sent = (expected.sent, found.sent) if not found.points else at_points(expected.sent, found.sent, found.points)
    return in_lock_step(*sent, found.silent, found.fields)


def free_runs(material: Material) -> Iterator[model.FreeRun]:
    """Each platform in free run, beside the reference as far as that run went."""
    expected = material.reference.lock_step
    for each in material.platforms[1:]:
        if expected is None or each.free_run is None:
            continue
        end = max((values[-1][0] for values in each.free_run.sent.values() if values), default=0)
        until = {name: [value for value in values if value[0] <= end] for name, values in expected.sent.items()}
        rows = in_free_run(until, each.free_run.sent, material.cycle_ns, each.free_run.silent)
        yield model.FreeRun(
            platform=each.name,
            seconds=end / 1e9,
            rows=rows,
        )


# -- faults -------------------------------------------------------------------------------------------------------


def faults(material: Material) -> Iterator[model.Fault]:
    """Yield the changes that each fault causes on the reference, and whether all platforms show them."""
    reference = material.reference.name
    sound = material.reference.lock_step
    statuses = [name for name, column in material.columns.items() if column.kind != "signal"]
    usual = set(behaviour.changes(sound.sent, statuses)) if sound else set()
    for each in material.faults:
        expected = each.recordings.get(reference)
        if expected is None:
            continue
        changed = [change for change in behaviour.changes(expected.sent, statuses) if change not in usual]
        yield model.Fault(
            name=each.name,
            title=each.title,
            description=each.description,
            changes=tuple(model.StatusChange(**change._asdict()) for change in changed),
            outcomes=tuple(_outcomes(each, expected, reference)),
        )


def _outcomes(fault: PlayedFault, expected: Recording, reference: str) -> Iterator[model.FaultOutcome]:
    for platform, found in fault.recordings.items():
        if platform == reference:
            continue
        held = _compared(expected, found)
        wrong = min((each for each in held.outputs if each.first), key=lambda each: each.first.time, default=None)  # type: ignore[union-attr]
        words = found.last_words if held.wrong and found.last_words != expected.last_words else ""
        yield model.FaultOutcome(
            platform=platform,
            values=held.values,
            wrong=held.wrong,
            first=wrong.first if wrong else None,
            name=wrong.name if wrong else "",
            last_words=words[:500],
        )


# -- traces -------------------------------------------------------------------------------------------------------


def traces(material: Material) -> Iterator[model.Trace]:
    """Yield the signals to draw: numbers that the functions send, then modes and errors."""
    drawable = [each for each in material.columns.values() if isinstance(each.shape, Number)]
    chosen = [
        *(each for each in drawable if each.kind == "signal"),
        *(each for each in drawable if each.kind == "mode"),
        *(each for each in drawable if each.kind == "error"),
    ]
    for column in chosen[:_TRACES]:
        lines = tuple(_lines(column, material))
        if lines:
            words = {number: name for name, number in column.shape.symbols} if isinstance(column.shape, Number) else {}
            yield model.Trace(name=column.name, unit=column.unit, words=words, lines=lines)


def _lines(column: Column, material: Material) -> Iterator[model.Line]:
    for each in material.platforms:
        recording = each.lock_step
        values = recording.sent.get(column.name, ()) if recording else ()
        points = [(time, number_of(text, column)) for time, text in values]
        if points:
            yield model.Line(platform=each.name, points=tuple(_thinned(points, material.end_ns)))


def number_of(text: str, column: Column) -> float | None:
    """The number of a value as text; None if it is not a number."""
    assert isinstance(column.shape, Number)
    symbols: Mapping[str, int] = dict(column.shape.symbols)
    if text in symbols:
        return float(symbols[text])
    try:
        value = {"true": 1.0, "false": 0.0}.get(text) if text in {"true", "false"} else float(text)
    except ValueError:
        return None
    return value if value is not None and math.isfinite(value) else None


def _thinned(points: Sequence[tuple[int, float | None]], end: int) -> Iterator[tuple[int, float | None]]:
    """Changes alone, and of those in one column of pixels the ones that say the most."""
    changed = [point for index, point in enumerate(points) if not index or point[1] != points[index - 1][1]]
    width = max(end // _COLUMNS, 1)
    columns: dict[int, list[tuple[int, float | None]]] = {}
    for point in changed:
        columns.setdefault(point[0] // width, []).append(point)
    for column in columns.values():
        numbers = [point for point in column if point[1] is not None]
        kept = {column[0], column[-1], *(point for point in column if point[1] is None)}
        if numbers:
            kept |= {min(numbers, key=lambda point: point[1]), max(numbers, key=lambda point: point[1])}  # type: ignore[arg-type, return-value]
        yield from sorted(kept, key=lambda point: point[0])
