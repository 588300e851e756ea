"""Stored values: learned parameters, beside the counts of errors."""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from sigcat.adapter.core.plan import CorePlan, Parameter
from sigcat.adapter.ros2.plan import NodePlan


class StoredLeaf(NamedTuple):
    """A number of a learned parameter, or an array of numbers: its key, and where it is in the value."""

    key: str
    place: str


class Learned(NamedTuple):
    """A learned parameter: read at the start, written at the end. Calibration is never written."""

    name: str
    leaves: Sequence[StoredLeaf]

    @property
    def is_split(self) -> bool:
        """Whether it has several lines in the file."""
        return len(self.leaves) > 1


def learned_parameters(node: NodePlan) -> Sequence[Learned]:
    """All of them."""
    return [Learned(each.named.name, _leaves(each, node)) for each in node.core.learned]


def _leaves(parameter: Parameter, node: NodePlan) -> tuple[StoredLeaf, ...]:
    """The lines of a parameter in the file: one for each number or array of numbers."""
    wire, key = parameter.value.wire, node.host.stored_keys[parameter.variable]
    if not wire.is_struct:
        return (StoredLeaf(key, ""),)
    indexes = [""] if wire.length is None else [f"[{i}]" for i in range(wire.length)]
    return tuple(
        StoredLeaf(f"{key}{index}{path}", f"{index}{path}") for index in indexes for path in _paths(wire.c, node.core)
    )


def _paths(struct: str, core: CorePlan) -> Iterator[str]:
    known = {each.name: each for each in core.structs}
    for field in known[struct].fields:
        if field.c not in known:
            yield f".{field.name}"
            continue
        indexes = [""] if field.length is None else [f"[{i}]" for i in range(field.length)]
        for index in indexes:
            yield from (f".{field.name}{index}{rest}" for rest in _paths(field.c, core))
