"""Changes of other YAML files, such as deployments and faults: paths, and values next to the signal that they are of."""

from collections.abc import Collection, Iterator

from yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from sigcat.function.function_json.conversion import IDENTITY
from sigcat.function.importing.yaml_edits import entries_of
from sigcat.migration.changed_text import Outcome, Place, not_convertible, replaced, value_changes
from sigcat.migration.migration import Migration
from sigcat.migration.numbers import converted_value
from sigcat.migration.path_changes import path_changes


def yaml_changes(
    file: str, text: str, root: Node, migration: Migration, current: Collection[str], values: list[str]
) -> Iterator[Outcome]:
    """Yield the changes of a file. `values` receives the new paths of signals whose values are converted."""
    yield from path_changes(file, text, root, migration)
    for mapping in _mappings(root):
        entries = entries_of(mapping)
        signal, value = (entries.get(name, (None, None))[1] for name in ("signal", "value"))
        if not isinstance(signal, ScalarNode) or not isinstance(value, ScalarNode):
            continue
        if migration.knows(signal.value) and signal.value not in current:
            yield from _value(file, text, signal.value, value, migration, values)


def _mappings(root: Node) -> Iterator[MappingNode]:
    waiting = [root]
    while waiting:
        node = waiting.pop()
        if isinstance(node, MappingNode):
            yield node
            waiting.extend(value for _, value in node.value)
        elif isinstance(node, SequenceNode):
            waiting.extend(node.value)


def _value(
    file: str, text: str, path: str, node: ScalarNode, migration: Migration, values: list[str]
) -> Iterator[Outcome]:
    fate = migration.fate(path, is_signal=True)
    both = migration.definitions(path, fate.path) if fate.is_certain else None
    if both is None:
        return
    named = tuple(value_changes(file, text, [node], (path, fate.path), migration, f"value of `{fate.path}`"))
    if named:
        yield from named
        return
    change = migration.unit_change(both[0].get("unit"), both[1].get("unit"))
    if change.conversion is None and change.old and change.new:
        reason = f"the unit changed from {change.old} to {change.new}, without a conversion."
        yield not_convertible(path, Place.of(file, node), reason, "Check the value.")
    elif change.conversion not in (None, IDENTITY):
        number = converted_value(node.value, change.conversion)
        if number is not None:
            values.append(fate.path)
            yield replaced(text, node, number, f"value of `{fate.path}`: {node.value} → {number}")
