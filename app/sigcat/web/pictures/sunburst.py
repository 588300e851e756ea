"""The catalogue as a sunburst: rings of branches, each as wide as it has signals; overlays stand out at the rim."""

from collections import Counter
from collections.abc import Iterator, Mapping
from functools import lru_cache
from itertools import groupby
from math import cos, pi, sin
from typing import NamedTuple

from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.definition import SIGNALS
from sigcat.web.template_filters import number

_INNER, _RING, _RIM = 92, 74, 11
_DEPTH = 3
_LEAST = 0.012
"""In radians; what is narrower is a hair."""
_LEAST_RIM = 0.008
_LABELLED = 0.14
_LONGEST = 11
"""Characters of a label."""
_COLOURS = 8
CENTRE = 360


class Segment(NamedTuple):
    """A branch or a signal as a piece of a ring."""

    outline: str
    """Path data of SVG."""
    style: str
    """Classes: the domain's colour and the depth, or the type of signal, or that overlays wrote it."""
    path: str
    title: str
    label: str
    turn: str
    """Transformation of the label; empty without one."""


class Sunburst(NamedTuple):
    """Every piece. On the rim stand the types of the signals, and outside of them the overlays."""

    segments: tuple[Segment, ...]
    rim: tuple[Segment, ...]
    total: int
    overlaid: int
    """Signals that an overlay added or changed."""
    types: tuple[tuple[str, int], ...]


class _Slice(NamedTuple):
    node: Node
    start: float
    angle: float
    depth: int
    colour: int


@lru_cache(maxsize=8)
def sunburst(catalogue: Catalogue) -> Sunburst | None:
    """The sunburst of a catalogue's signal tree; None without signals."""
    if not catalogue.roots:
        return None
    root = catalogue.roots[0]
    leaves = _leaves(root)
    total = leaves[root.path]
    if not total:
        return None
    slices = list(_slices(root, leaves, 2 * pi / total))
    segments = tuple(_segment(each, leaves) for each in slices if each.angle >= _LEAST and not each.node.is_leaf)
    signals = list(_leaves_in_order(root, leaves))
    inner = _INNER + _DEPTH * _RING + 4
    by_type = _rim([f"leaf {node.type}" for node in signals], inner, {f"leaf {name}": name for name in SIGNALS})
    overlaid = ["overlaid" if _is_overlaid(node) else "" for node in signals]
    by_overlay = _rim(overlaid, inner + _RIM + 3, {"overlaid": "overlaid signal"})
    types = Counter(node.type for node in signals)
    return Sunburst(segments, (*by_type, *by_overlay), total, len(list(filter(None, overlaid))), tuple(types.items()))


def _leaves(root: Node) -> dict[str, int]:
    """Return the number of signals at or below each node."""
    counts: dict[str, int] = {}
    for node in reversed(list(root.walk())):
        counts[node.path] = int(node.is_leaf) + sum(counts[child.path] for child in node.children)
    return counts


def _slices(root: Node, leaves: dict[str, int], unit: float) -> Iterator[_Slice]:
    waiting = [(root, 0.0, 0, 0)]
    while waiting:
        node, start, depth, colour = waiting.pop()
        for index, child in enumerate(_ordered(node, leaves)):
            angle = leaves[child.path] * unit
            own = index % _COLOURS if depth == 0 else colour
            yield _Slice(child, start, angle, depth, own)
            if depth + 1 < _DEPTH:
                waiting.append((child, start, depth + 1, own))
            start += angle


def _ordered(node: Node, leaves: dict[str, int]) -> list[Node]:
    """The largest branches first, signals of the branch itself last."""
    return sorted(node.children, key=lambda child: (child.is_leaf, -leaves[child.path]))


def _segment(piece: _Slice, leaves: dict[str, int]) -> Segment:
    node, start, angle, depth, colour = piece
    inner = _INNER + depth * _RING
    style = f"hue{colour} ring{depth}"
    count = leaves[node.path]
    title = f"{node.path}: {number(count)} signal{'s' if count != 1 else ''}"
    has_label = angle >= _LABELLED * (_INNER + _RING) / (inner + _RING / 2)
    label = (node.name if len(node.name) <= _LONGEST else f"{node.name[: _LONGEST - 1]}…") if has_label else ""
    turn = _turn(start + angle / 2, inner + _RING / 2) if has_label else ""
    return Segment(_arc(start, angle, inner, inner + _RING - 2), style, node.path, title, label, turn)


def _leaves_in_order(root: Node, leaves: dict[str, int]) -> Iterator[Node]:
    waiting = [root]
    while waiting:
        node = waiting.pop()
        if node.is_leaf:
            yield node
        waiting.extend(reversed(_ordered(node, leaves)))


def _rim(kinds: list[str], inner: float, words: Mapping[str, str]) -> Iterator[Segment]:
    """A ring of one piece for each run of equal kinds; nothing where the kind is empty."""
    unit = 2 * pi / len(kinds)
    position = 0
    for kind, run in groupby(kinds):
        count = len(list(run))
        if kind:
            outline = _arc(position * unit, max(count * unit, _LEAST_RIM), inner, inner + _RIM)
            noun = f"{words.get(kind, kind)}{'s' if count > 1 else ''}"
            yield Segment(outline, kind, "", f"{number(count)} {noun}", "", "")
        position += count


def _is_overlaid(node: Node) -> bool:
    return any(statement.file.overlay for statement in node.definition.statements)


def _arc(start: float, angle: float, inner: float, outer: float) -> str:
    """A piece of a ring, clockwise from the top. A whole ring is drawn nearly whole, as SVG has no full arcs."""
    end = start + min(angle, 2 * pi - 0.0005)
    large = int(end - start > pi)
    a, b, c, d = _point(start, outer), _point(end, outer), _point(end, inner), _point(start, inner)
    return f"M{a}A{outer:g} {outer:g} 0 {large} 1 {b}L{c}A{inner:g} {inner:g} 0 {large} 0 {d}Z"


def _point(angle: float, radius: float) -> str:
    return f"{CENTRE + radius * sin(angle):.1f} {CENTRE - radius * cos(angle):.1f}"


def _turn(angle: float, radius: float) -> str:
    """Along the radius, readable from the left on the left half."""
    degrees = angle * 180 / pi - 90
    x, y = _point(angle, radius).split()
    return f"translate({x} {y}) rotate({degrees + 180 if angle > pi else degrees:.1f})"
