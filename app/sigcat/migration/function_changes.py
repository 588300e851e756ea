"""Changes of a function.yaml. The C code stays untouched: an entry states the unit and the datatype that its variable
keeps, and the adapter converts.
"""

from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

from yaml.nodes import MappingNode, Node, ScalarNode

from sigcat.catalogue.model.datatypes import INTEGER_RANGES, element_of, is_array, is_numeric
from sigcat.function.function_json.conversion import IDENTITY
from sigcat.function.importing.yaml_edits import Edit, entries_of, items_of, value_at
from sigcat.function.importing.yaml_text import inline
from sigcat.migration.changed_text import (
    Outcome,
    Place,
    Replacement,
    end_of,
    line_of,
    not_convertible,
    replaced,
    value_changes,
)
from sigcat.migration.migration import Migration
from sigcat.migration.path_changes import changed_path, path_changes
from sigcat.names import last_name, parent_path


class FunctionFile(NamedTuple):
    """A function.yaml as text."""

    file: str
    text: str
    root: Node
    migration: Migration


def function_changes(function: FunctionFile) -> Iterator[Outcome]:
    """Yield the changes of a function.yaml."""
    yield from path_changes(function.file, function.text, function.root, function.migration)
    yield from _definitions(function)
    for component in items_of(value_at(function.root, "components")):
        for runnable in items_of(value_at(component, "runnables")):
            for kind in ("data", "parameters"):
                for entry in items_of(value_at(runnable, kind)):
                    yield from _entry(entry, function)


def _definitions(function: FunctionFile) -> Iterator[Outcome]:
    """Yield the changes of signals that the function defines below branches of the catalogue."""
    for path, (key, values) in entries_of(value_at(function.root, "define", "data")).items():
        migration = function.migration
        if not migration.knows(path):
            above = parent_path(path)
            if migration.knows(above) and not migration.fate(above).is_certain:
                continue
            fate = migration.fate(path)
            if fate.is_certain and fate.path != path:
                yield replaced(function.text, key, fate.path, f"`{path}` → `{fate.path}`")
        yield from _respelled(path, entries_of(values), function)


def _entry(entry: Node, function: FunctionFile) -> Iterator[Outcome]:
    """Yield what keeps the variable of a signal or parameter as it is."""
    entries = entries_of(entry)
    key, node = entries.get("path", (None, None))
    if key is None or not isinstance(node, ScalarNode) or not isinstance(entry, MappingNode):
        return
    migration, path = function.migration, node.value
    fate = migration.fate(path, is_signal=True)
    if not migration.knows(path) and path not in migration.old.nodes:
        yield from _own(node, function)
    if not fate.is_certain:
        return
    yield from _respelled(path, entries, function)
    both = migration.definitions(path, fate.path)
    if both is None:
        return
    yield from _names(path, fate.path, entries, function)
    added = dict(_kept(path, fate.path, *both, entries, migration))
    if "unit" in added and added["unit"] is None:
        old, new = (values.get("unit") or "none" for values in both)
        reason = f"the unit changed from {old} to {new}, without a conversion."
        yield not_convertible(path, Place.of(function.file, node), reason, "Adapt the code, and state its unit.")
    elif "datatype" in added and added["datatype"] is None:
        old, new = (values.get("datatype") for values in both)
        reason = f"the datatype changed from {old} to {new}."
        yield not_convertible(path, Place.of(function.file, node), reason, "Adapt the code.")
    elif added:
        yield _with_keys(entry, key, node, added, function.text)


def _names(path: str, target: str, entries: Mapping[str, Any], function: FunctionFile) -> Iterator[Outcome]:
    """Yield the changes of values that have another name; the numbers of the code stay."""
    for key in ("values", "init"):
        node = entries.get(key, (None, None))[1]
        nodes = [node, *items_of(node), *(name for name, _ in entries_of(node).values())]
        note = f"`{key}` of `{target}`"
        yield from value_changes(function.file, function.text, nodes, (path, target), function.migration, note)


def _own(node: ScalarNode, function: FunctionFile) -> Iterator[Outcome]:
    """Yield the change of a signal that another file defines below a branch that moved."""
    if "." in node.value:
        fate = function.migration.fate(node.value)
        if fate.is_certain and fate.path != node.value:
            yield replaced(function.text, node, fate.path, f"`{node.value}` → `{fate.path}`")
        elif not fate.is_certain:
            yield from changed_path(function.file, function.text, node, function.migration)


def _kept(
    path: str,
    target: str,
    old: Mapping[str, Any],
    new: Mapping[str, Any],
    entries: Mapping[str, Any],
    migration: Migration,
) -> Iterator[tuple[str, Any]]:
    """Yield the keys by which an entry stays what it was; None where it cannot."""
    if "name" not in entries and last_name(path) != last_name(target):
        yield "name", last_name(path)
    change = migration.unit_change(old.get("unit"), new.get("unit"))
    if change.conversion is None and (change.old or "unit" in entries):
        yield "unit", None
    elif change.conversion not in (None, IDENTITY) and "unit" not in entries:
        yield "unit", migration.unit_in_new(change.old) or None
    before, after = old.get("datatype"), new.get("datatype")
    if before != after and "datatype" not in entries:
        yield "datatype", before if _are_numbers(before, after) else None
        yield from _range(old, entries)


def _range(old: Mapping[str, Any], entries: Mapping[str, Any]) -> Iterator[tuple[str, Any]]:
    """Yield the limits of a variable that is a whole number: the new datatype may hold larger values."""
    limits = INTEGER_RANGES.get(element_of(str(old.get("datatype"))))
    if limits is None or not entries.keys().isdisjoint(("unit", "factor", "offset")):
        return
    for name, limit in zip(("min", "max"), limits, strict=True):
        if name not in entries:
            yield name, old.get(name, limit)


def _are_numbers(before: Any, after: Any) -> bool:
    """Whether both are numbers, or arrays of numbers, which the adapter converts."""
    if not isinstance(before, str) or not isinstance(after, str) or is_array(before) is not is_array(after):
        return False
    return is_numeric(element_of(before)) and is_numeric(element_of(after))


def _respelled(path: str, entries: Mapping[str, tuple[ScalarNode, Node]], function: FunctionFile) -> Iterator[Outcome]:
    """Yield the change of a unit that has another key in the new catalogue."""
    node = entries.get("unit", (None, None))[1]
    if not isinstance(node, ScalarNode) or function.migration.old.vocabulary.is_unknown(node.value):
        return
    unit = function.migration.unit_in_new(node.value)
    if not unit:
        place = Place.of(function.file, node)
        yield not_convertible(path, place, f"the new tree has no unit {node.value!r}.", "Define it in a units file.")
    elif unit != node.value:
        yield replaced(function.text, node, unit, f"`unit` of `{path}`: {node.value} → {unit}")


def _with_keys(entry: MappingNode, key: ScalarNode, node: Node, added: Mapping[str, Any], text: str) -> Replacement:
    """Add keys behind `path`."""
    at = end_of(text, node)
    pairs = [f"{name}: {inline(value)}" for name, value in added.items()]
    note = f"`{', '.join(pairs)}` keeps the variable of `{node.value}`"
    if entry.flow_style:
        return Replacement(Edit(at, at, "".join(f", {pair}" for pair in pairs)), line_of(key), note)
    end = text.find("\n", at)
    at = len(text) if end < 0 else end - (text[end - 1 : end] == "\r")
    line_break = "\r\n" if "\r\n" in text else "\n"
    indent = " " * int(key.start_mark.column)
    return Replacement(Edit(at, at, "".join(f"{line_break}{indent}{pair}" for pair in pairs)), line_of(key), note)
