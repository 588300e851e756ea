"""A set of functions as boxes from left to right, in the order in which data flows. Units are pixels."""

from collections.abc import Iterable, Mapping, Sequence
from itertools import zip_longest
from math import ceil
from typing import NamedTuple

from sigcat.function.exchange import Side
from sigcat.function.sets.wiring import Link, Wiring

_NARROWEST, _GAP, _MARGIN = 270, 130, 40
_ROW, _HEAD, _BETWEEN = 26, 44, 36
_LETTER, _TITLE_LETTER, _AROUND = 7.3, 9.5, 48
"""Width of a letter of a name and of a title, and of the space around the two names of a row."""


class Pin(NamedTuple):
    """A signal at the edge of a box."""

    x: int
    y: int
    is_out: bool
    name: str
    path: str
    is_free: bool
    """Whether it leads out of the set."""


class Box(NamedTuple):
    """A function."""

    x: int
    y: int
    width: int
    height: int
    name: str
    pins: tuple[Pin, ...]


class Wire(NamedTuple):
    """A link as a curve."""

    curve: str
    """Path data of SVG."""
    middle: tuple[float, float]
    path: str
    mismatches: tuple[str, ...]


class WiringDiagram(NamedTuple):
    """Positions of all elements."""

    boxes: tuple[Box, ...]
    wires: tuple[Wire, ...]
    width: int
    height: int


def wiring_diagram(wiring: Wiring) -> WiringDiagram:
    """The diagram of a wiring."""
    columns = _columns(wiring)
    linked = {
        (end.function, end.identity, end.provides) for link in wiring.links for end in (link.provider, link.consumer)
    }
    boxes: list[Box] = []
    x = _MARGIN
    for names in columns:
        ends = {name: _ends_of(name, wiring) for name in names}
        width, y = max(_width(name, ends[name]) for name in names), _MARGIN // 2
        for name in names:
            boxes.append(_box(name, x, y, width, ends[name], linked))
            y += boxes[-1].height + _BETWEEN
        x += width + _GAP
    pins = {(box.name, pin.path, pin.is_out): pin for box in boxes for pin in box.pins}
    wires = tuple(_wire(link, pins) for link in wiring.links)
    width = max((box.x + box.width for box in boxes), default=_MARGIN) + _MARGIN
    return WiringDiagram(tuple(boxes), wires, width, max((box.y + box.height for box in boxes), default=0) + 20)


def _columns(wiring: Wiring) -> list[list[str]]:
    """Functions by how many others stand before them in the flow. In a circle, the first one named is first."""
    before: Mapping[str, set[str]] = {name: set() for name in wiring.functions}
    for link in wiring.links:
        before[link.consumer.function].add(link.provider.function)
    placed: dict[str, int] = {}
    waiting = list(wiring.functions)
    while waiting:
        ready = [name for name in waiting if before[name] <= placed.keys()] or waiting[:1]
        column = max(placed.values(), default=-1) + 1
        placed.update(dict.fromkeys(ready, column))
        waiting = [name for name in waiting if name not in placed]
    columns = max(placed.values(), default=-1) + 1
    return [[name for name, column in placed.items() if column == index] for index in range(columns)]


def _ends_of(name: str, wiring: Wiring) -> list[Side]:
    linked = [end for link in wiring.links for end in (link.provider, link.consumer)]
    ends = (end for end in (*wiring.from_outside, *linked, *wiring.to_outside) if end.function == name)
    return list({(end.identity, end.provides): end for end in ends}.values())


def _width(name: str, ends: Sequence[Side]) -> int:
    """Width of a box in which the two names of each row are next to each other."""
    taken, given = ([len(end.data.name) for end in ends if end.provides is side] for side in (False, True))
    rows = [sum(row) * _LETTER for row in zip_longest(taken, given, fillvalue=0)]
    return ceil(max(_NARROWEST, _AROUND + max(rows, default=0), _AROUND + len(name) * _TITLE_LETTER))


def _box(name: str, x: int, y: int, width: int, ends: Sequence[Side], linked: Iterable[tuple[str, str, bool]]) -> Box:
    known = set(linked)
    pins: list[Pin] = []
    rows = [0, 0]
    for end in ends:
        side = int(end.provides)
        at = y + _HEAD + _ROW * rows[side] + _ROW // 2
        rows[side] += 1
        is_free = (end.function, end.identity, end.provides) not in known
        pins.append(Pin(x + width * side, at, end.provides, end.data.name, end.identity, is_free))
    return Box(x, y, width, _HEAD + _ROW * max(*rows, 1) + 10, name, tuple(pins))


def _wire(link: Link, pins: Mapping[tuple[str, str, bool], Pin]) -> Wire:
    start, end = pins[link.provider.function, link.path, True], pins[link.consumer.function, link.path, False]
    bend = max(abs(end.x - start.x) / 2, 60)
    curve = f"M{start.x} {start.y} C{start.x + bend:g} {start.y} {end.x - bend:g} {end.y} {end.x} {end.y}"
    messages = tuple(mismatch.message for mismatch in link.mismatches)
    return Wire(curve, ((start.x + end.x) / 2, (start.y + end.y) / 2), link.path, messages)
