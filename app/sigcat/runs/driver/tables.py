"""The tables of the driver: the functions of a set, where values go, and what is sent to whom."""

from collections.abc import Sequence
from typing import Literal, NamedTuple

from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.host.connections import Connections
from sigcat.adapter.host.numbering import Numbers
from sigcat.adapter.host.shapes import SECONDS, Number, Packing, packing
from sigcat.adapter.templates import rendered

Kind = Literal["VALUE", "DURATION", "STORED", "GONE"]


class Target(NamedTuple):
    """Target of a record of the driver's input, and its content. Its number is its index."""

    kind: Kind
    member: int
    number: int
    packing: Packing


def targets_of(connections: Connections, numbers: Numbers) -> tuple[Target, ...]:
    """All of them: first the entries, in their order."""
    found: list[Target] = []
    seen = [0] * len(connections.members)
    for entry in connections.entries:
        found.append(Target("VALUE", entry.member, seen[entry.member], packing(entry.shape)))
        seen[entry.member] += 1
    found += [
        Target("DURATION", numbers.owner(number), number, packing(SECONDS)) for number in range(len(numbers.calls))
    ]
    kept = [0] * len(connections.members)
    for each in numbers.kept:
        found.append(Target("STORED", each.member, kept[each.member], packing(each.shape)))
        kept[each.member] += 1
    found += [Target("GONE", member, member, _YES) for member in range(len(connections.members))]
    return tuple(found)


_YES = packing(Number("boolean", ()))


class _Exit(NamedTuple):
    """A value that is sent: its bytes, and the numbers of its targets."""

    size: int
    route: Sequence[int]


def tables_file(connections: Connections, numbers: Numbers) -> GeneratedFile:
    """The file of the tables."""
    targets = targets_of(connections, numbers)
    sizes = [packing(each.shape).struct.size for each in connections.exits]
    return GeneratedFile(
        "sigcat_tables.c",
        rendered(
            "runs/driver/sigcat_tables.c.j2",
            functions=[f"{member.name}_Driver" for member in connections.members],
            targets=targets,
            exits=[_Exit(size, route) for size, route in zip(sizes, connections.routes, strict=True)],
            call_count=len(numbers.calls),
            largest=max(each.packing.struct.size for each in targets),
        ).encode(),
    )
