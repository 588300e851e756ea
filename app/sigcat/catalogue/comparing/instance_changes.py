"""Changes of `instances`: which branches say something else, and which nodes come and go for that reason."""

from collections.abc import Mapping
from typing import Any, NamedTuple

from sigcat.catalogue.comparing.changes import same
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.definition import BRANCH, instances_of
from sigcat.names import parent_path


class Replacement(NamedTuple):
    """Nodes that one side has only because a branch has other instances."""

    paths: set[str]
    tops: Mapping[str, list[str]]
    """By the branch with the instances, the topmost of these paths."""


def changed_holders(old: Catalogue, new: Catalogue, *, may_be_lost: bool = False) -> set[str]:
    """Branches whose `instances` say something else, or make other nodes where the words are, or may be, lost."""
    holders = set()
    known: dict[tuple[int, int], bool] = {}
    for path, before in old.nodes.items():
        after = new.nodes.get(path)
        if after is None or before.type != BRANCH or after.type != BRANCH:
            continue
        if before.definition.is_instance or after.definition.is_instance:
            continue
        key = (id(before.definition), id(after.definition))
        if key not in known:
            known[key] = not same(instances_as_written(before), instances_as_written(after)) and _differ_in_effect(
                before, after
            )
        if known[key] and not (may_be_lost and _have_the_same_below(before, after)):
            holders.add(path)
    return holders


def _differ_in_effect(before: Node, after: Node) -> bool:
    """Whether the instances differ, compared by what was written if both sides have that, else by the expansion."""
    is_known = [_words_of(node) is not None or not _generated(node) for node in (before, after)]
    return all(is_known) or sorted(_generated(before)) != sorted(_generated(after))


def _have_the_same_below(before: Node, after: Node) -> bool:
    """Whether the words are lost on one side, and the nodes are those that the other side has."""
    if _words_of(before) is not None and _words_of(after) is not None:
        return False
    return {node.path for node in before.walk()} == {node.path for node in after.walk()}


def instances_as_written(node: Node) -> Any:
    """`instances` as written; where only the expansion is known, the names that it made."""
    words = _words_of(node)
    return words if words is not None else (_generated(node) or None)


def _words_of(node: Node) -> Any:
    """The last value that the layers gave `instances`; the expansion drops it from the values."""
    for statement in reversed(node.definition.statements):
        if "instances" in statement.values:
            return instances_of(statement.values) or None
    return None


def _generated(node: Node, prefix: str = "") -> list[str]:
    """Names of the instances of a branch, relative to it: `Row1`, `Row1.Left`."""
    found = []
    for child in node.children:
        if child.definition.is_instance:
            found += [prefix + child.name, *_generated(child, f"{prefix}{child.name}.")]
    return found


def replaced(nodes: Mapping[str, Node], catalogue: Catalogue, other: Catalogue, holders: set[str]) -> Replacement:
    """The nodes that only one side has because a branch has other instances.

    Their definitions are on both sides; only their paths differ. `nodes` has parents first.
    """
    paths: set[str] = set()
    tops: dict[str, list[str]] = {}
    templates = {node.template for node in other.nodes.values()} if holders else set()
    for path, node in nodes.items() if holders else ():
        above = parent_path(path)
        if above in paths:
            paths.add(path)
        elif above not in nodes and node.template in templates:
            holder = _holder_of(path, catalogue)
            if holder in holders:
                paths.add(path)
                tops.setdefault(holder, []).append(path)
    return Replacement(paths, tops)


def _holder_of(path: str, catalogue: Catalogue) -> str:
    """The branch that a node is in, past the names of instances."""
    above = parent_path(path)
    while above in catalogue.nodes and catalogue.nodes[above].definition.is_instance:
        above = parent_path(above)
    return above
