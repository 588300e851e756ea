"""Changes of paths in any YAML file: scalars that are the path of a node of the old catalogue."""

from collections.abc import Iterator

from yaml.nodes import MappingNode, Node, ScalarNode, SequenceNode

from sigcat.migration.changed_text import Outcome, Place, replaced, undecided
from sigcat.migration.migration import Migration


def scalars_in(node: Node) -> Iterator[ScalarNode]:
    """Yield the scalars of a document, keys included; those behind an alias once."""
    seen: set[int] = set()
    waiting = [node]
    while waiting:
        each = waiting.pop()
        if id(each) in seen:
            continue
        seen.add(id(each))
        if isinstance(each, ScalarNode):
            yield each
        elif isinstance(each, SequenceNode):
            waiting.extend(reversed(each.value))
        elif isinstance(each, MappingNode):
            waiting.extend(part for pair in reversed(each.value) for part in reversed(pair))


def path_changes(file: str, text: str, node: Node, migration: Migration) -> Iterator[Outcome]:
    """Yield the changes of the paths in a part of a document."""
    for each in scalars_in(node):
        if "." in each.value and migration.knows(each.value):
            yield from changed_path(file, text, each, migration)


def changed_path(file: str, text: str, node: ScalarNode, migration: Migration) -> Iterator[Outcome]:
    """Yield the change of one path."""
    path = node.value
    old = migration.old.get(path)
    fate = migration.fate(path, is_signal=old is not None and old.is_leaf)
    if not fate.is_certain:
        yield from undecided(path, fate, Place.of(file, node), migration)
    elif fate.path != path:
        yield replaced(text, node, fate.path, f"`{path}` → `{fate.path}`")
