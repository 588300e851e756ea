"""Compare two catalogues, node by node as expanded, and report each change once.

Instances share definitions: what changed in one definition is one change, whose paths are listed. What came or went
as a whole is one change at the topmost path.
"""

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, NamedTuple

from sigcat.catalogue.comparing.changes import ORDER, AttributeChange, Change, Kind, worst
from sigcat.catalogue.comparing.compatibility import ROWS, Vocabularies, attribute_change, attribute_changes
from sigcat.catalogue.comparing.forms import orders, trees, with_effects
from sigcat.catalogue.comparing.instance_changes import Replacement, changed_holders, instances_as_written, replaced
from sigcat.catalogue.comparing.moves import Move, find_moves
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.catalogue.model.definition import CORE_ATTRIBUTES, STRUCT
from sigcat.catalogue.reading.yaml_document import collector_paused
from sigcat.names import parent_path

SAID_BY_A_MOVE = frozenset(("fka", "deprecation"))
"""Attributes that only say where a node moved."""


def compare(old: Catalogue, new: Catalogue, ignored: frozenset[str] = frozenset()) -> tuple[Change, ...]:
    """Every change from `old` to `new`, both expanded, in the order of the paths.

    `ignored` are attributes that one side cannot know, as an exported JSON has lost `arraysize`.
    """
    with collector_paused():
        comparison = _Comparison(old, new, ignored)
        changes = [*comparison.changed(), *comparison.left(), *comparison.arrived()]
        both = trees(old, new, ignored)
        explained = (with_effects(change, both) for change in _grouped(changes))
        return tuple(sorted(explained, key=lambda change: change.sort_key))


class _Single(NamedTuple):
    """A change at one path, and the templates by which it is grouped with those of other instances."""

    change: Change
    template: str
    former_template: str = ""


class _Comparison:
    """Two catalogues, and what explains each node that only one of them has."""

    def __init__(self, old: Catalogue, new: Catalogue, ignored: frozenset[str]) -> None:
        self._old = old
        self._new = new
        self._ignored = ignored
        self._vocabularies = Vocabularies(old.vocabulary, new.vocabulary)
        self._known: dict[tuple[int, int], tuple[AttributeChange, ...]] = {}
        self._holders = changed_holders(old, new, may_be_lost="instances" in ignored)
        gone = {path: node for path, node in old.nodes.items() if path not in new.nodes}
        came = {path: node for path, node in new.nodes.items() if path not in old.nodes}
        self._went: Replacement = replaced(gone, old, new, self._holders)
        self._entered: Replacement = replaced(came, new, old, self._holders)
        self._find_moves(gone, came)

    def _find_moves(self, gone: dict[str, Node], came: dict[str, Node]) -> None:
        """Settle what moved, and with it what is gone and what is new.

        A path that held a signal and is a branch now, or the other way round, may be two nodes: one that moved away,
        and one that came.
        """
        displaced = [p for p, n in self._old.nodes.items() if p in self._new.nodes and _is_other(n, self._new.nodes[p])]
        gone = {path: node for path, node in gone.items() if path not in self._went.paths}
        came = {path: node for path, node in came.items() if path not in self._entered.paths}
        if displaced:
            gone = _with(gone, displaced, self._old)
            came = _with(came, displaced, self._new)
        self._moves: Mapping[str, Move] = find_moves(self._old, self._new, gone, came)
        self._targets = {move.target for move in self._moves.values()}
        for path in displaced:
            if path not in self._moves and path not in self._targets:
                del gone[path], came[path]
        self._gone: Mapping[str, Node] = gone
        self._came: Mapping[str, Node] = came

    # -- the three sorts of changes, one path at a time

    def changed(self) -> Iterator[_Single]:
        """Nodes that both have, and nodes that moved along with the branch above them."""
        for path, before in self._old.nodes.items():
            after = self._new.nodes.get(path)
            if after is None or path in self._gone:
                continue
            attributes = (*self._attributes(before, after), *self._order(before, after))
            if self._ignored and "." not in path:
                attributes = tuple(attribute for attribute in attributes if not _is_lost_at_the_root(attribute))
            if path in self._holders:
                yield self._holder(path, before, after, attributes)
            elif attributes:
                yield _Single(_changed(after, attributes), _template(before, after))
        for path, move in self._moves.items():
            attributes = self._attributes_of_moved(path, move)
            if attributes and self._went_along(path):
                before, after = self._old.nodes[path], self._new.nodes[move.target]
                change = _changed(after, attributes)._replace(former=path, former_paths=(path,))
                yield _Single(change, after.template, before.template)

    def left(self) -> Iterator[_Single]:
        """Nodes that moved, and nodes that are gone."""
        top: dict[str, str] = {}
        for path in self._gone:
            above = parent_path(path)
            goes_along = self._went_along(path) if path in self._moves else above in top and above not in self._moves
            top[path] = top[above] if goes_along else path
        leaves = _leaves(top, self._gone)
        for path, count in leaves.items():
            move = self._moves.get(path)
            yield self._moved(path, move, count) if move else self._removed(path, count)

    def arrived(self) -> Iterator[_Single]:
        """Nodes that are new."""
        top: dict[str, str] = {}
        for path in self._came:
            if path not in self._targets:
                top[path] = top.get(parent_path(path), path)
        for path, count in _leaves(top, self._came).items():
            node = self._came[path]
            rule = "property-added" if node.type == "property" else "added"
            yield _Single(_change_of_node("added", rule, node, count), node.template)

    # -- one change

    def _attributes(self, before: Node, after: Node) -> tuple[AttributeChange, ...]:
        """Instances share definitions, so each pair of definitions is compared once."""
        if before.definition is after.definition:
            return ()
        key = (id(before.definition), id(after.definition))
        known = self._known.get(key)
        if known is None:
            known = attribute_changes(before.values, after.values, self._vocabularies, self._ignored)
            self._known[key] = known
        return known

    def _order(self, before: Node, after: Node) -> Iterator[AttributeChange]:
        """The order of the children that both have, if it differs."""
        if before.children and after.children and ORDER not in self._ignored:
            old, new = orders(before, after)
            if old != new:
                yield attribute_change(ORDER, old, new, "reordered")

    def _attributes_of_moved(self, path: str, move: Move) -> tuple[AttributeChange, ...]:
        attributes = self._attributes(self._old.nodes[path], self._new.nodes[move.target])
        return tuple(attribute for attribute in attributes if attribute.name not in SAID_BY_A_MOVE)

    def _went_along(self, path: str) -> bool:
        """Whether a node only followed the branch above it."""
        move, above = self._moves[path], self._moves.get(parent_path(path))
        return above is not None and move.target == f"{above.target}.{self._old.nodes[path].name}"

    def _holder(self, path: str, before: Node, after: Node, attributes: tuple[AttributeChange, ...]) -> _Single:
        came = tuple(self._entered.tops.get(path, ()))
        went = tuple(self._went.tops.get(path, ()))
        rule = "instances-removed" if went else "instances-added" if came else "instances-respelled"
        instances = attribute_change("instances", instances_as_written(before), instances_as_written(after), rule)
        change = _changed(after, (instances, *attributes))._replace(came=came, went=went)
        return _Single(change, _template(before, after))

    def _moved(self, path: str, move: Move, leaves: int) -> _Single:
        before, after = self._old.nodes[path], self._new.nodes[move.target]
        change = _change_of_node("moved", "moved", after, leaves)._replace(
            former=path,
            former_paths=(path,),
            attributes=self._attributes_of_moved(path, move),
            evidence=move.evidence,
        )
        return _Single(change, after.template, before.template)

    def _removed(self, path: str, leaves: int) -> _Single:
        node = self._gone[path]
        note = node.values.get("deprecation")
        change = _change_of_node("removed", "removed", node, leaves)._replace(
            note=note if isinstance(note, str) else ""
        )
        return _Single(change, node.template)


def _is_lost_at_the_root(attribute: AttributeChange) -> bool:
    """Whether an export may have left it out: it has all extended attributes, but at the root only those asked for."""
    return attribute.name not in CORE_ATTRIBUTES and (attribute.old is None or attribute.new is None)


def _change_of_node(kind: Kind, rule: str, node: Node, leaves: int) -> Change:
    return Change(kind, ROWS[rule].for_type(node.type), rule, node.path, node.type, (node.path,), leaves)


def _changed(node: Node, attributes: tuple[AttributeChange, ...]) -> Change:
    compatibility = worst(attribute.compatibility for attribute in attributes)
    rule = next(attribute.rule for attribute in attributes if attribute.compatibility == compatibility)
    return Change("changed", compatibility, rule, node.path, node.type, (node.path,), 0, attributes=attributes)


def _template(before: Node, after: Node) -> str:
    """The path without names of instances, from the side that knows them."""
    return after.template if after.template != after.path else before.template


def _leaves(top: Mapping[str, str], nodes: Mapping[str, Node]) -> dict[str, int]:
    """Return the number of signals of each topmost path."""
    counts = dict.fromkeys(top.values(), 0)
    for path, topmost in top.items():
        counts[topmost] += nodes[path].is_leaf
    return counts


def _is_other(before: Node, after: Node) -> bool:
    return before.is_leaf is not after.is_leaf and STRUCT not in (before.type, after.type)


def _with(nodes: Mapping[str, Node], paths: Iterable[str], catalogue: Catalogue) -> dict[str, Node]:
    """The nodes and those at `paths`, parents first as in the catalogue."""
    wanted = {*nodes, *paths}
    return {path: node for path, node in catalogue.nodes.items() if path in wanted}


# -- grouping -----------------------------------------------------------------------------------------------------


def _grouped(singles: Iterable[_Single]) -> Iterator[Change]:
    """Equal changes of instances as one change."""
    groups: dict[tuple[Any, ...], list[_Single]] = {}
    texts: dict[int, str] = {}
    for single in singles:
        change = single.change
        content = texts.get(id(change.attributes))
        if content is None:
            content = texts[id(change.attributes)] = repr(change.attributes)
        key = (change.kind, single.template, single.former_template, change.leaves, content, change.evidence)
        groups.setdefault((*key, change.note), []).append(single)
    for group in groups.values():
        yield _joined(group) if len(group) > 1 else group[0].change


def _joined(group: list[_Single]) -> Change:
    first, template, former_template = group[0]
    changes = [single.change for single in group]
    return first._replace(
        path=template,
        former=former_template,
        paths=tuple(change.path for change in changes),
        former_paths=tuple(change.former for change in changes if change.former),
        leaves=sum(change.leaves for change in changes),
        came=tuple(path for change in changes for path in change.came),
        went=tuple(path for change in changes for path in change.went),
    )
