"""Changes of an overlay: paths, units, numbers, datatypes and labels of instances.

An attribute that repeats the old catalogue follows the new one. Any other value is the overlay's own; numbers are
converted if the unit that they are in changes.
"""

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from sigcat import codes
from sigcat.catalogue.comparing.changes import same
from sigcat.catalogue.model.datatypes import INTEGER_RANGES
from sigcat.catalogue.network.mapping_attributes import ATTRIBUTES
from sigcat.catalogue.reading.yaml_document import Builder, Unbuildable
from sigcat.findings import Finding
from sigcat.function.function_json.conversion import IDENTITY, Linear
from sigcat.function.importing.yaml_edits import Edit, entries_of, items_of
from sigcat.function.importing.yaml_text import inline
from sigcat.migration.changed_text import (
    Outcome,
    Place,
    Replacement,
    end_of,
    line_of,
    not_convertible,
    number_replaced,
    replaced,
    undecided,
    value_changes,
)
from sigcat.migration.mapping_changes import mapping_changes, physical_values
from sigcat.migration.migration import Fate, Migration, UnitChange
from sigcat.migration.numbers import converted, is_whole
from sigcat.migration.path_changes import path_changes
from sigcat.names import parent_path

_NUMBERS = ("min", "max", "default", "resolution")
_REPEATED = ("datatype", "type", "instances", "allowed", "enum", "arraysize", "pattern")
"""Attributes that follow the new catalogue if they repeat the old one."""
_NAMED = ("default", "allowed")
"""Attributes with names of values."""
_NO_PATHS = frozenset(("description", "comment", "fka", "deprecation", "unit", "type", "min", "max", *ATTRIBUTES))
"""Attributes that name no node, or former ones only."""
_FULL = frozenset(("type", "datatype"))
"""Attributes with which an overlay defines a signal by itself."""
_BRANCHES = ("branch", "struct")
_WILDCARD = "*"


class Statement(NamedTuple):
    """A statement of an overlay about a node: its key, its attributes, and its place."""

    key: ScalarNode
    value: Node
    entries: Mapping[str, tuple[ScalarNode, Node]]
    path: str
    fate: Fate
    place: Place

    def stated(self, name: str) -> Any:
        """Value of an attribute; None if it is absent or has none."""
        node = self.entries.get(name, (None, None))[1]
        try:
            return Builder().value(node) if node is not None else None
        except Unbuildable:
            return None


class OverlayFile(NamedTuple):
    """An overlay as text, and the path below which another file includes it."""

    file: str
    text: str
    root: Node
    prefix: str
    migration: Migration


def overlay_changes(overlay: OverlayFile) -> Iterator[Outcome]:
    """Yield the changes of an overlay."""
    statements = list(_statements(overlay))
    targets: dict[str, list[Statement]] = {}
    for statement in statements:
        targets.setdefault(statement.fate.path if statement.fate.is_certain else statement.path, []).append(statement)
    for statement in statements:
        others = [each for each in targets.get(statement.fate.path, ()) if each.path != statement.path]
        if statement.fate.status == "moved" and others:
            yield _met(statement, others[0].path)
        else:
            yield from _of_statement(statement, overlay)


def _statements(overlay: OverlayFile) -> Iterator[Statement]:
    pairs = overlay.root.value if isinstance(overlay.root, MappingNode) else ()
    for key, value in pairs:
        if not isinstance(key, ScalarNode):
            continue
        path = f"{overlay.prefix}.{key.value}" if overlay.prefix else key.value
        fate = fate_of(path, overlay.migration)
        yield Statement(key, value, entries_of(value), path, fate, Place.of(overlay.file, key))


def fate_of(path: str, migration: Migration) -> Fate:
    """Return what becomes of a path, which may have wildcards."""
    return _of_wildcard(path, migration) if _WILDCARD in path else migration.fate(path)


def _of_wildcard(path: str, migration: Migration) -> Fate:
    """Return what becomes of a path with wildcards: it stays if all of its nodes do."""
    from fnmatch import fnmatchcase

    matches = [each for each in migration.old.nodes if fnmatchcase(each, path)]
    changed = [each for each in matches if migration.fate(each).status != "same"]
    if not changed:
        return Fate("same", path)
    targets = tuple(fate.path for each in changed if (fate := migration.fate(each)).path)
    return Fate("choice", "", 0, f"It matches {changed[0]}, which moved.", targets[:3]) if targets else Fate("gone", "")


def _met(statement: Statement, other: str) -> Finding:
    message = f"{statement.path} and {other} both become {statement.fate.path}."
    return codes.MOVE_UNDECIDED.finding(message, *statement.place, statement.path, fix="Merge them by hand.")


def _of_statement(statement: Statement, overlay: OverlayFile) -> Iterator[Outcome]:
    fate, migration = statement.fate, overlay.migration
    if fate.status == "gone" and statement.stated("delete") is True:
        yield _without(statement, overlay)
        return
    if not fate.is_certain:
        yield from _of_undecided(statement, overlay)
        return
    yield from _moved_key(statement, overlay)
    both = migration.definitions(statement.path, fate.path)
    if both is not None:
        yield from _attributes(statement, *both, overlay)
    else:
        yield from _own_unit(statement, overlay)
    for name, (_, node) in statement.entries.items():
        if name not in _NO_PATHS and name != "instances":
            yield from path_changes(overlay.file, overlay.text, node, migration)


def _without(statement: Statement, overlay: OverlayFile) -> Outcome:
    """Remove a statement that deletes a node: the new catalogue does not have it."""
    text, start = overlay.text, int(statement.key.start_mark.index)
    end = text.find("\n", end_of(text, statement.value))
    note = f"`{statement.path}` removed: the new tree does not have the deleted node"
    return Replacement(Edit(start, len(text) if end < 0 else end + 1, ""), line_of(statement.key), note)


def _of_undecided(statement: Statement, overlay: OverlayFile) -> Iterator[Outcome]:
    if not _is_defined_here(statement, overlay):
        yield from undecided(statement.path, statement.fate, statement.place, overlay.migration)
        return
    if statement.stated("type") not in _BRANCHES:
        message = f"{statement.path} was removed. The overlay adds it again. {statement.fate.why}".strip()
        yield codes.REMOVED_NODE_DEFINED_BY_OVERLAY.finding(
            message, *statement.place, statement.path, fix="Remove it, or keep it as your own signal."
        )
    yield from _own_unit(statement, overlay)


def _is_defined_here(statement: Statement, overlay: OverlayFile) -> bool:
    """Whether the overlay defines a removed node as a whole, below a branch that the new catalogue or the overlay has."""
    if statement.fate.status != "gone":
        return False
    above = parent_path(statement.path)
    has_branch = overlay.migration.has_definition(above) or above in entries_of(overlay.root)
    is_branch = statement.stated("type") in _BRANCHES
    return has_branch and (is_branch or statement.entries.keys() >= _FULL)


def _moved_key(statement: Statement, overlay: OverlayFile) -> Iterator[Outcome]:
    target = statement.fate.path
    if target == statement.path:
        return
    note = f"`{statement.path}` → `{target}`"
    if overlay.prefix:
        above = overlay.migration.fate(overlay.prefix).path
        if not target.startswith(f"{above}."):
            message = f"{statement.path} moved to {target}, out of the branch that the file is included in."
            yield codes.MOVE_UNDECIDED.finding(message, *statement.place, statement.path, fix="Move it by hand.")
            return
        target = target[len(above) + 1 :]
    if target != statement.key.value:
        yield replaced(overlay.text, statement.key, target, note)


# -- attributes ---------------------------------------------------------------------------------------------------


def _attributes(
    statement: Statement, old: Mapping[str, Any], new: Mapping[str, Any], overlay: OverlayFile
) -> Iterator[Outcome]:
    if statement.fate.path == statement.path and same(dict(old), dict(new)):
        yield from _own_unit(statement, overlay)
        return
    names = overlay.migration.value_names(statement.path, statement.fate.path)
    is_renamed = [names.get(each, each) for each in old.get("allowed") or ()] == new.get("allowed")
    for name in _REPEATED if not is_renamed else (each for each in _REPEATED if each != "allowed"):
        yield from _repeated(statement, name, old.get(name), new.get(name), overlay)
    yield from _names(statement, overlay)
    change = _unit_of_values(statement, old, new, overlay.migration)
    if change is None:
        yield from _own_unit(statement, overlay)
    else:
        yield from _in_new_unit(statement, change, _datatype(statement, old, new), overlay)


def _repeated(statement: Statement, name: str, old: Any, new: Any, overlay: OverlayFile) -> Iterator[Outcome]:
    if name not in statement.entries or new is None or same(old, new) or not same(statement.stated(name), old):
        return
    node = statement.entries[name][1]
    note = f"`{name}` of `{statement.fate.path}`: {_short(old)} → {_short(new)}"
    if isinstance(new, str):
        yield replaced(overlay.text, node, new, note)
    else:
        edit = Edit(int(node.start_mark.index), end_of(overlay.text, node), inline(new))
        yield Replacement(edit, line_of(node), note)


def _names(statement: Statement, overlay: OverlayFile) -> Iterator[Outcome]:
    """Yield the changes of values that have another name."""
    move = (statement.path, statement.fate.path)
    for attribute, (_, node) in statement.entries.items():
        nodes = [node, *items_of(node)] if attribute in _NAMED else []
        nodes += physical_values(attribute, node) if attribute in ATTRIBUTES else []
        note = f"`{attribute}` of `{statement.fate.path}`"
        yield from value_changes(overlay.file, overlay.text, nodes, move, overlay.migration, note)


def _datatype(statement: Statement, old: Mapping[str, Any], new: Mapping[str, Any]) -> str:
    """Return the datatype of the node with the overlay, after the migration."""
    stated = statement.stated("datatype")
    return str(new.get("datatype") if stated is None or stated == old.get("datatype") else stated)


def _unit_of_values(
    statement: Statement, old: Mapping[str, Any], new: Mapping[str, Any], migration: Migration
) -> UnitChange | None:
    """Return the change of the unit that numbers of the overlay are in; None if the overlay has its own unit."""
    stated = statement.stated("unit")
    if isinstance(stated, str) and migration.unit_change(stated, old.get("unit")).conversion != IDENTITY:
        return None
    change = migration.unit_change(old.get("unit"), new.get("unit"))
    return change._replace(old=stated) if isinstance(stated, str) else change


def _in_new_unit(statement: Statement, change: UnitChange, datatype: str, overlay: OverlayFile) -> Iterator[Outcome]:
    conversion = change.conversion
    has_values = any(name in statement.entries for name in (*_NUMBERS, *ATTRIBUTES))
    if conversion is None:
        if has_values or "unit" in statement.entries:
            reason = f"the unit changed from {change.old or 'none'} to {change.new or 'none'}, without a conversion."
            yield not_convertible(statement.path, statement.place, reason, "Check its values and its unit.")
        return
    if "unit" in statement.entries:
        yield from _unit(statement, change.new, overlay)
    if conversion == IDENTITY:
        return
    found = [*_numbers(statement, conversion, datatype, overlay), *_mappings(statement, conversion, overlay)]
    yield from found
    if "unit" not in statement.entries and any(isinstance(each, Replacement) for each in found):
        yield _added_unit(statement, change.new, overlay)


def _unit(statement: Statement, unit: str, overlay: OverlayFile) -> Iterator[Outcome]:
    node = statement.entries["unit"][1]
    if isinstance(node, ScalarNode) and node.value != unit:
        note = f"`unit` of `{statement.fate.path}`: {node.value} → {unit}"
        yield replaced(overlay.text, node, unit, note)


def _own_unit(statement: Statement, overlay: OverlayFile) -> Iterator[Outcome]:
    """Respell the unit of a node that only the overlay knows, or whose unit is the overlay's own."""
    stated = statement.stated("unit")
    if not isinstance(stated, str) or overlay.migration.old.vocabulary.is_unknown(stated):
        return
    unit = overlay.migration.unit_in_new(stated)
    if unit:
        yield from _unit(statement, unit, overlay)
    else:
        place = Place.of(overlay.file, statement.entries["unit"][1])
        yield not_convertible(
            statement.path, place, f"the new tree has no unit {stated!r}.", "Define it in a units file."
        )


def _numbers(statement: Statement, conversion: Linear, datatype: str, overlay: OverlayFile) -> Iterator[Outcome]:
    for name in _NUMBERS:
        node = statement.entries.get(name, (None, None))[1]
        for each in node.value if isinstance(node, SequenceNode) else [node] if node is not None else []:
            linear = Linear(conversion.factor) if name == "resolution" else conversion
            yield from _number(statement, name, each, linear, datatype, overlay)


def _number(
    statement: Statement, name: str, node: Node, conversion: Linear, datatype: str, overlay: OverlayFile
) -> Iterator[Outcome]:
    written = node.value if isinstance(node, ScalarNode) else ""
    number = converted(written, conversion)
    if number is None:
        return
    if datatype.removesuffix("[]") in INTEGER_RANGES and not is_whole(number) and name != "resolution":
        reason = f"`{name}` is {number} in the new unit, which {datatype} does not hold."
        yield not_convertible(statement.path, Place.of(overlay.file, node), reason, "Write a whole number.")
    elif number != written:
        yield number_replaced(overlay.text, node, number, f"`{name}` of `{statement.fate.path}`: {written} → {number}")


def _mappings(statement: Statement, conversion: Linear, overlay: OverlayFile) -> Iterator[Outcome]:
    for name in ATTRIBUTES:
        if name in statement.entries:
            key, node = statement.entries[name]
            yield from mapping_changes(name, key, node, conversion, overlay.text)


def _added_unit(statement: Statement, unit: str, overlay: OverlayFile) -> Outcome:
    """State the unit, so that the overlay says what its numbers mean."""
    assert isinstance(statement.value, MappingNode)
    first = statement.value.value[0][0]
    start = int(first.start_mark.index)
    if statement.value.flow_style:
        added = f"unit: {inline(unit)}, "
    else:
        line = overlay.text[overlay.text.rfind("\n", 0, start) + 1 : start]
        added = f"unit: {inline(unit)}{_line_break(overlay.text)}{' ' * len(line)}"
    return Replacement(Edit(start, start, added), line_of(first), f"`unit` of `{statement.fate.path}`: {unit} stated")


def _line_break(text: str) -> str:
    return "\r\n" if "\r\n" in text else "\n"


def _short(value: Any) -> str:
    text = str(value)
    return text if len(text) <= 40 else f"{text[:39]}…"
