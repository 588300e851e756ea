"""Stored values: learned parameters, beside the counts of errors."""

from collections.abc import Iterator, Mapping, Sequence

from sigcat.adapter.core.plan import WireStruct
from sigcat.adapter.ros2.plan import NodePlan


def learned_places(node: NodePlan) -> Mapping[str, Sequence[str]]:
    """Places of the numbers, and of the arrays of numbers, in each learned parameter: each is a line of the file."""
    structs = {each.name: each for each in node.core.structs}
    wires = {each.named.name: each.value.wire for each in node.core.learned}
    return {name: [*_places(wire.c, wire.length, structs)] for name, wire in wires.items()}


def _places(c: str, length: int | None, structs: Mapping[str, WireStruct]) -> Iterator[str]:
    if c not in structs:
        yield ""
        return
    for index in [""] if length is None else [f"[{i}]" for i in range(length)]:
        for field in structs[c].fields:
            yield from (f"{index}.{field.name}{rest}" for rest in _places(field.c, field.length, structs))
