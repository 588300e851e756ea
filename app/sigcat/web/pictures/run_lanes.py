"""Errors, safety reactions and modes of a run as lanes below its signals: a bar for each time that a word holds."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sigcat.runs.columns import Column
from sigcat.runs.recording.picture import HEIGHT, LEFT, WIDTH, Picture
from sigcat.runs.recording.series import Point, Series
from sigcat.web.run_words import seconds_text, word_of

BAR = 20
_PITCH = 46
_TITLE = 22
_FOOT = 44
_LETTER = 7.5
_TONES = 4
_KEYS = 4


class Bar(NamedTuple):
    """A time in which a word holds, in pixels; or a short one with several words."""

    x: float
    width: float
    text: str
    """The word, where there is room for it."""
    tone: str
    title: str


class Key(NamedTuple):
    """A word that no bar of a lane has room for."""

    x: float
    word: str
    tone: str


class Lane(NamedTuple):
    """One of them."""

    y: int
    """Height of its bars; its title is above."""
    title: str
    bars: tuple[Bar, ...]
    keys: tuple[Key, ...]
    """Beside the title."""


class Lanes(NamedTuple):
    """All of them, with the height of the picture that they end."""

    lanes: tuple[Lane, ...]
    bottom: int
    """Position of the time axis."""
    bad: tuple[Bar, ...]
    """Times in which a state is bad, as bands behind the signals."""
    height: int
    start: int
    """Left edge of the picture."""
    left: int = LEFT
    width: int = WIDTH
    panel_height: int = HEIGHT
    bar_height: int = BAR


def gap_bars(series: Series, timeout: int, drawn: Picture) -> tuple[Bar, ...]:
    """Bars for the pauses of a signal after its time-out, up to the next value or the end of the picture."""
    last = series.latest + timeout
    spans = [*series.gaps, (last, round(drawn.last))] if last < drawn.last else series.gaps
    shown = [(max(start, drawn.first), min(end, drawn.last)) for start, end in spans]
    return tuple(_gap(start, end, drawn) for start, end in shown if start < end)


def _gap(start: float, end: float, drawn: Picture) -> Bar:
    says = f"time-out passed from {seconds_text(round(start))} s to {seconds_text(round(end))} s"
    return Bar(_x(start, drawn), round(max(_x(end, drawn) - _x(start, drawn), 1.5), 2), "", "late", says)


class _Span(NamedTuple):
    start: float
    end: float
    values: tuple[float, ...]


def run_lanes(drawn: Picture, statuses: Sequence[tuple[Column, Series]]) -> Lanes:
    """The lanes below a picture of signals, on its axis of time."""
    top = drawn.height - _FOOT + (_TITLE if drawn.panels else 0)
    lanes = tuple(
        _lane(top + index * _PITCH + _TITLE, column, list(_spans_of(series.points, drawn)), drawn)
        for index, (column, series) in enumerate(statuses)
    )
    bottom = lanes[-1].y + BAR if lanes else drawn.height - _FOOT
    longest = max((len(tick.label) for panel in drawn.panels for tick in panel.ticks), default=0)
    bad = tuple(bar for lane in lanes for bar in lane.bars if bar.tone == "bad")
    return Lanes(lanes, bottom, bad, bottom + _FOOT, max(0, LEFT - 16 - round(longest * _LETTER)))


def _lane(y: int, column: Column, spans: Sequence[_Span], drawn: Picture) -> Lane:
    bars = tuple(_bar(span, column, drawn) for span in spans)
    values = dict.fromkeys(value for span in spans for value in span.values)
    written = {bar.text for bar in bars}
    words = [(word_of(value, column.shape), _tone((value,), column)) for value in values]
    return Lane(y, column.name, bars, tuple(_keys([each for each in words if each[0] not in written][:_KEYS])))


def _keys(words: Sequence[tuple[str, str]]) -> Iterator[Key]:
    """From the right to the left."""
    x = float(LEFT + WIDTH)
    for word, tone in reversed(words):
        x -= len(word) * _LETTER + 30
        yield Key(x, word, tone)


def _bar(span: _Span, column: Column, drawn: Picture) -> Bar:
    words = [word_of(value, column.shape) for value in span.values]
    x, until = _x(span.start, drawn), _x(span.end, drawn)
    width = max(until - x, 1.5)
    fits = len(words) == 1 and len(words[0]) * _LETTER + 10 <= width
    says = f"from {seconds_text(round(span.start))} s to {seconds_text(round(span.end))} s"
    title = f"{words[0] if len(words) == 1 else 'changes between ' + ' and '.join(words[:_KEYS])} {says}"
    return Bar(x, round(width, 2), words[0] if fits else "", _tone(span.values, column), title)


def _spans_of(points: Sequence[Point], drawn: Picture) -> Iterator[_Span]:
    return _spans(list(_changes(points)), drawn.last, (drawn.last - drawn.first) / WIDTH)


def _x(time: float, drawn: Picture) -> float:
    return round(LEFT + WIDTH * (time - drawn.first) / (drawn.last - drawn.first), 2)


def _changes(points: Sequence[Point]) -> Iterator[Point]:
    last = None
    for time, value in points:
        if value != last:
            yield time, value
        last = value


def _spans(changes: Sequence[Point], end: float, shortest: float) -> Iterator[_Span]:
    """Times between changes. Those that are shorter than a pixel, one after the other, are one."""
    short: _Span | None = None
    for index, (time, value) in enumerate(changes):
        until = changes[index + 1][0] if index + 1 < len(changes) else end
        if until - time < shortest:
            short = _Span(short.start, until, (*short.values, value)) if short else _Span(time, until, (value,))
            short = short._replace(values=tuple(dict.fromkeys(short.values)))
            continue
        if short:
            yield short
            short = None
        yield _Span(time, until, (value,))
    if short:
        yield short


def _tone(values: Sequence[float], column: Column) -> str:
    """Return the style of a bar: a mode by its index, anything else by whether its state is good."""
    if column.good is not None:
        return "good" if set(values) == {column.good} else "bad"
    if len(set(values)) > 1:
        return "several"
    numbers = [number for _, number in getattr(column.shape, "symbols", ())]
    return f"tone-{numbers.index(values[0]) % _TONES}" if values[0] in numbers else "several"
