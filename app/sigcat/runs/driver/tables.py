"""The tables of the driver: the functions of a set, where values go, and what is sent to whom."""

from collections.abc import Iterable
from typing import Literal, NamedTuple

from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.host.connections import Connections
from sigcat.adapter.host.numbering import Numbers
from sigcat.adapter.host.shapes import SECONDS, Number, Packing, packing

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


def tables_file(connections: Connections, numbers: Numbers) -> GeneratedFile:
    """The file of the tables."""
    names = [f"{member.name}_Driver" for member in connections.members]
    targets = targets_of(connections, numbers)
    sizes = [each.packing.struct.size for each in targets]
    sent = [packing(each.shape).struct.size for each in connections.exits]
    rows = [
        '#include "sigcat_driver.h"',
        *(f"extern const sigcat_function {name};" for name in names),
        _table("sigcat_function *const sigcat_functions", (f"&{name}" for name in names)),
        f"const uint32_t sigcat_function_count = {len(names)}U;",
        _table("sigcat_entry sigcat_entries", (
            f"{{SIGCAT_{each.kind}, {each.member}U, {each.number}U, {size}U}}" for each, size in zip(targets, sizes, strict=True)
        )),
        f"const uint32_t sigcat_entry_count = {len(targets)}U;",
        *(_table(f"uint32_t route_{number}", (f"{target}U" for target in route), "static const")
          for number, route in enumerate(connections.routes)),
        _table("sigcat_exit sigcat_exits", (
            f"{{{size}U, {len(route)}U, route_{number}}}"
            for number, (size, route) in enumerate(zip(sent, connections.routes, strict=True))
        )),
        f"const uint32_t sigcat_call_count = {len(numbers.calls)}U;",
        f"const uint32_t sigcat_largest = {max(sizes)}U;",
    ]  # fmt: skip
    return GeneratedFile("sigcat_tables.c", ("\n".join(rows) + "\n").encode())


def _table(name: str, values: Iterable[str], kind: str = "const") -> str:
    """A table; one without rows has an empty one, as C wants it."""
    rows = list(values) or ["0"]
    return "\n".join([f"{kind} {name}[] = {{", *(f"    {row}," for row in rows), "};"])
