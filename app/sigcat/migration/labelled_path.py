"""Paths with labels of instances in brackets: `Vehicle.Cabin.Seat[Row1][DriverSide].Height`."""

import re
from collections.abc import Iterator, Mapping
from typing import NamedTuple

from sigcat.catalogue.model.catalogue import Catalogue

_SEGMENT = re.compile(r"(\w+)((?:\[[\w*]+\])*)")
SAME = "*"
"""Label of a target: those of the source."""


class Segment(NamedTuple):
    """A name, and the labels of the instance of that branch."""

    name: str
    labels: tuple[str, ...] = ()


LabelledPath = tuple[Segment, ...]


def parsed(text: str) -> LabelledPath | None:
    """Return the path that a table has as text; None if it is not a path."""
    segments = []
    for part in text.split("."):
        match = _SEGMENT.fullmatch(part)
        if match is None:
            return None
        segments.append(Segment(match[1], tuple(re.findall(r"\[([\w*]+)\]", match[2]))))
    return tuple(segments)


def plain(path: LabelledPath) -> str:
    """Return a path as trees have it: `Vehicle.Cabin.Seat.Row1.DriverSide.Height`."""
    return ".".join(name for segment in path for name in (segment.name, *segment.labels))


def bracketed(path: LabelledPath) -> str:
    """Return a path as tables have it."""
    return ".".join(segment.name + "".join(f"[{label}]" for label in segment.labels) for segment in path)


def template(path: LabelledPath) -> str:
    """Return the path without labels."""
    return ".".join(segment.name for segment in path)


def labelled(path: str, catalogue: Catalogue) -> tuple[LabelledPath, str]:
    """Tell labels from names by a catalogue. Returns the known beginning of a path, and the rest."""
    names = path.split(".")
    segments: list[Segment] = []
    here, above = "", ""
    for index, name in enumerate(names):
        here, inner = (f"{here}.{name}" if here else name), (f"{above}.{name}" if above else name)
        node = catalogue.get(here)
        if node is not None and node.definition.is_instance and segments:
            segments[-1] = segments[-1]._replace(labels=(*segments[-1].labels, name))
        elif inner in catalogue.definitions:
            segments.append(Segment(name))
            above = inner
        else:
            return tuple(segments), ".".join(names[index:])
    return tuple(segments), ""


def moved(start: LabelledPath, rest: LabelledPath, target: LabelledPath) -> LabelledPath:
    """Return a path whose `start` moved to `target`, in the same instances."""
    labels = {segment.name: segment.labels for segment in start}
    labels.setdefault(target[-1].name, start[-1].labels)
    return (*_with_labels(target, labels), *rest)


def _with_labels(target: LabelledPath, labels: Mapping[str, tuple[str, ...]]) -> Iterator[Segment]:
    for segment in target:
        carried = labels.get(segment.name, ())
        own = [label for each in segment.labels for label in (carried if each == SAME else (each,))]
        yield segment._replace(labels=tuple(own) if segment.labels else carried)
