"""A function as a box: inputs on the left, outputs on the right, its calls within. Units are pixels."""

import math
from collections.abc import Iterable
from typing import Literal, NamedTuple

from sigcat.function.function_json.interfaces.role import PROVIDER
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.function_json.runnable import Runnable
from sigcat.function.function_json.walk import absent, calls_of, data, errors, methods, parameters, safety_reactions
from sigcat.web.template_filters import unit as typeset_unit

_LABELS_LEFT, _LABELS_RIGHT = 344, 776
_CHARACTER = 7.4
"""Width of a character of a label, on average."""
_LEAST_REACH = 120
"""For the headings of the ports."""
_ROW = 24
_HEADING = 34
_LONGEST = 48
"""Characters of a label outside of the box."""
_LONGEST_INSIDE = 24

Side = Literal["left", "right"]


class Port(NamedTuple):
    """An interface at the edge of the box."""

    kind: Literal["signal", "parameter", "error", "reaction", "mode", "method"]
    outer: str
    """Label outside: the place of the interface in the catalogue."""
    inner: str
    """Label inside: its name in the function, with datatype or unit."""
    path: str
    """Path in the catalogue; empty if the document has none."""
    title: str
    mark: str = ""
    """After the label outside: ` (optional)`."""
    y: int = 0
    side: Side = "left"


class Heading(NamedTuple):
    """The name of a group of ports."""

    y: int
    side: Side
    text: str


class Call(NamedTuple):
    """A call, with when it runs."""

    y: int
    name: str
    when: str


class Diagram(NamedTuple):
    """Positions of all elements."""

    name: str
    ports: tuple[Port, ...]
    headings: tuple[Heading, ...]
    calls: tuple[Call, ...]
    top: int
    """Left edge of the ports."""
    height: int
    left: int
    """Left edge of the picture: labels on the left end in one line, and the longest sets how far out they reach."""
    width: int


def interface_diagram(function: FunctionJson) -> Diagram:
    """The diagram of a function."""
    name = function.info.function_name
    calls = tuple(
        Call(64 + 20 * i, call.name.removeprefix(f"{name}_"), when(call)) for i, call in enumerate(calls_of(function))
    )
    top = 64 + 20 * len(calls) + 4
    left, left_headings, left_end = _placed("left", _incoming(function), top)
    right, right_headings, right_end = _placed("right", _outgoing(function), top)
    height = max(left_end, right_end, top) + 16
    start = _LABELS_LEFT - _reach(left)
    width = _LABELS_RIGHT + _reach(right) - start
    return Diagram(name, (*left, *right), (*left_headings, *right_headings), calls, top, height, start, width)


def _reach(ports: Iterable[Port]) -> int:
    """Return the outward width of the labels of ports."""
    return max([_LEAST_REACH, *(math.ceil(_CHARACTER * len(port.outer + port.mark)) for port in ports)])


def when(call: Runnable) -> str:
    """When a call runs, in a few words."""
    parts = []
    if call.run_type == "Cyclic" and call.cycle_time is not None:
        parts.append(f"every {call.cycle_time} ms")
        if call.execution_offset not in (None, "0"):
            parts.append(f"from {call.execution_offset} ms on")
    else:
        words = {"Init": "at start-up", "Shutdown": "at shutdown", "EventTriggered": "on events"}
        parts.append(words.get(call.run_type, call.run_type))
    watchdog = call.watchdog
    if watchdog and (watchdog.alive or watchdog.deadline or watchdog.logical):
        parts.append("supervised")
    return ", ".join(parts)


def short(path: str) -> str:
    """A path without its root; of a long one, the last names that fit."""
    text = path.partition(".")[2] or path
    if len(text) <= _LONGEST:
        return text
    end = text[-_LONGEST + 1 :]
    return f"…{end.partition('.')[2] or end}"


def _incoming(function: FunctionJson) -> list[tuple[str, list[Port]]]:
    taken = [
        Port("parameter", _label(p.vss_path, p.name), _with(p.name, p.units), p.vss_path or "", p.description.raw)
        for _, _, p in parameters(function)
    ]
    reactions = [
        Port("reaction", r.name, "", r.vss_path or "", f"{r.description.raw} Set by {', '.join(r.errors)}.")
        for _, _, r in safety_reactions(function)
    ]
    return [
        ("Signals in", _signals(function, provided=False)),
        ("Parameters", taken),
        ("Safety reactions", reactions),
        ("Mode", _modes(function, "In")),
        ("Methods used", _methods(function, provided=False)),
    ]


def _outgoing(function: FunctionJson) -> list[tuple[str, list[Port]]]:
    reported = [Port("error", e.name, "", e.vss_path or "", e.description.raw) for _, _, e in errors(function)]
    return [
        ("Signals out", _signals(function, provided=True)),
        ("Errors", reported),
        ("Mode", _modes(function, "Out")),
        ("Methods offered", _methods(function, provided=True)),
    ]


def _signals(function: FunctionJson, *, provided: bool) -> list[Port]:
    there = [(each, " (optional)" if each.is_optional else "") for _, _, each in data(function)]
    lacking = [(each, " (optional, not in this catalogue)") for _, _, each in absent(function)]
    return [
        Port("signal", _label(s.vss_path, s.name), _with(s.name, s.units), s.vss_path or "", s.description.raw, mark)
        for s, mark in (*there, *lacking)
        if (s.role == PROVIDER) is provided
    ]


def _methods(function: FunctionJson, *, provided: bool) -> list[Port]:
    return [
        Port("method", m.name, "", "", m.description.raw)
        for _, _, m in methods(function)
        if (m.role == PROVIDER) is provided
    ]


def _modes(function: FunctionJson, direction: str) -> list[Port]:
    return [
        Port("mode", m.name, " ".join(m.modes), m.vss_path or "", f"{m.description.raw} {', '.join(m.modes)}")
        for m in function.mode_interfaces or ()
        if m.direction == direction
    ]


def _label(path: str | None, name: str) -> str:
    return short(path) if path else name


def _with(name: str, unit: str | None) -> str:
    return f"{name} [{typeset_unit(unit)}]" if unit else name


def _placed(side: Side, groups: Iterable[tuple[str, list[Port]]], top: int) -> tuple[list[Port], list[Heading], int]:
    """Ports and headings one below the other, and where they end."""
    ports: list[Port] = []
    headings: list[Heading] = []
    y = top
    for text, items in groups:
        if not items:
            continue
        headings.append(Heading(y + _HEADING - 10, side, text))
        y += _HEADING
        for item in items:
            inner = item.inner if len(item.inner) <= _LONGEST_INSIDE else f"{item.inner[: _LONGEST_INSIDE - 1]}…"
            ports.append(item._replace(inner=inner, y=y + _ROW // 2, side=side))
            y += _ROW
    return ports, headings, y
