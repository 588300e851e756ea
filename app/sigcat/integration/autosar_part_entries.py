"""For every field of a function and its components, besides interfaces: its place in the Integration JSON of AUTOSAR."""

from collections.abc import Iterator
from typing import NamedTuple

from sigcat.function.exchange import Part
from sigcat.function.function_json.code import CodeInterface
from sigcat.integration.report import Entry, FieldTarget, Targets, entries, fields_of, same_names

_META: Targets = {
    "Authority": "MetaInformation/Authority",
    "SchemaAuthor": "MetaInformation/Author",
    "Date": "MetaInformation/Date",
    **dict.fromkeys(
        ("SchemaVersion", "SchemaDescription"),
        FieldTarget("none", "each format has its own version and description"),
    ),
}
_CODE: Targets = same_names("Code/", fields_of(CodeInterface))


class PartTables(NamedTuple):
    """Targets that differ between the platforms of AUTOSAR."""

    function: Targets
    mode: Targets
    component: Targets


def part_entries(part: Part, tables: PartTables, modes: str = "") -> Iterator[Entry]:
    """Entries of a component, and before the first one those of its function. `modes` is the place of its modes, if they have one."""
    function, name = part.function, part.function_name
    if part.is_first:
        yield from entries(name, name, "document", function.meta, _META)
        yield from entries(name, name, "function", function.info, tables.function)
        if function.code is not None:
            yield from entries(name, name, "code", function.code, _CODE, below=part.name)
        for mode in function.modes or ():
            below = modes and f"{modes}/{mode.name}"
            yield from entries(name, mode.name, "active mode", mode, tables.mode, below=below)
    yield from entries(name, part.name, "component", part.component, tables.component, below=part.name)
