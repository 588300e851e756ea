"""Moved nodes: by the former paths of a node, by the deprecation of a removed node, or by guess."""

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from sigcat.catalogue.comparing.changes import Evidence
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.names import last_name, parent_path

Nodes = Mapping[str, Node]


class Instance(NamedTuple):
    """One node in terms of definitions: the path of its definition, and the names of the instances that it is in."""

    template: str
    names: tuple[str, ...]


_SUCCESSOR = re.compile(r"\b(?:moved|renamed|replaced)\s+(?:to|by|with)\s+[`'\"]?([A-Za-z][\w.]*\w)", re.IGNORECASE)


class Move(NamedTuple):
    """New path of a node, and the evidence for it."""

    target: str
    evidence: Evidence


@dataclass
class _Search:
    """The search for moves: both sides, and the moves that were found so far."""

    old: Catalogue
    new: Catalogue
    gone: Nodes
    came: Nodes
    old_paths: Mapping[Instance, str]
    new_paths: Mapping[Instance, str]
    moves: dict[str, Move] = field(default_factory=dict)
    taken: set[str] = field(default_factory=set)
    """New paths to which something moved."""


def find_moves(old: Catalogue, new: Catalogue, gone: Nodes, came: Nodes) -> dict[str, Move]:
    """Moves by former path. `gone` and `came` are the nodes to explain, parents first.

    A branch moves with all that is found under the same names below its new path; a branch of which everything moved
    alike has moved itself.
    """
    if not gone:
        return {}
    search = _Search(old, new, gone, came, _paths(old, gone), _paths(new, new.nodes))
    _follow_former_paths(search)
    _follow_deprecations(search)
    _guess(search)
    _gather_branches(search)
    return search.moves


def _paths(catalogue: Catalogue, nodes: Nodes) -> dict[Instance, str]:
    known: dict[str, tuple[str, ...]] = {"": ()}
    return {Instance(node.template, _instance_names(path, catalogue, known)): path for path, node in nodes.items()}


def _instance_names(path: str, catalogue: Catalogue, known: dict[str, tuple[str, ...]]) -> tuple[str, ...]:
    names = known.get(path)
    if names is None:
        above = _instance_names(parent_path(path), catalogue, known)
        node = catalogue.get(path)
        names = (*above, last_name(path)) if node is not None and node.definition.is_instance else above
        known[path] = names
    return names


def _record(search: _Search, path: str, target: str, evidence: Evidence) -> None:
    """Record a move, and those of everything below that is at the new path under the same names."""
    waiting = [(path, target)]
    while waiting:
        former, now = waiting.pop()
        if former in search.moves or former not in search.gone or now not in search.new.nodes:
            continue
        search.moves[former] = Move(now, evidence)
        search.taken.add(now)
        waiting.extend((child.path, f"{now}.{child.name}") for child in search.gone[former].children)


def _follow_former_paths(search: _Search) -> None:
    claims: dict[str, list[str]] = {}
    for path, node in search.came.items():
        for former in _texts(node.values.get("fka")):
            claims.setdefault(former, []).append(path)
    if not claims:
        return
    names = {path: instance.names for instance, path in search.new_paths.items() if path in search.came}
    for former, paths in claims.items():
        for path in paths:
            source = search.old_paths.get(Instance(former, names[path]))
            if source is None and len(paths) == 1 and former in search.gone:
                source = former
            if source is not None and path not in search.taken:
                _record(search, source, path, "fka")


def _texts(value: Any) -> Iterator[str]:
    yield from (item for item in value if isinstance(item, str)) if isinstance(value, list) else ()


def _follow_deprecations(search: _Search) -> None:
    """A successor may have stood in the old tree already, and may succeed several nodes."""
    for instance, path in search.old_paths.items():
        text = search.gone[path].values.get("deprecation")
        if path in search.moves or not isinstance(text, str):
            continue
        for match in _SUCCESSOR.finditer(text):
            target = _successor(path, match[1], instance.names, search)
            if target:
                _record(search, path, target, "deprecation")
                break


def _successor(path: str, name: str, instances: tuple[str, ...], search: _Search) -> str:
    """The new node that a deprecation names: by its whole path, or from the branch of the old node on upwards.

    A name without a dot is looked for in the same branch only.
    """
    above = parent_path(path)
    while above:
        candidate = f"{above}.{name}"
        if candidate in search.new.nodes and candidate != path:
            return candidate
        above = parent_path(above) if "." in name else ""
    if "." not in name:
        return ""
    found = search.new_paths.get(Instance(name, instances)) or (name if name in search.new.nodes else "")
    return found if found != path else ""


def _guess(search: _Search) -> None:
    """Signals with the same definition under another path, if no other definition in either tree is the same."""
    gone = {path: node for path, node in search.gone.items() if node.is_leaf and path not in search.moves}
    came = {path: node for path, node in search.came.items() if node.is_leaf and path not in search.taken}
    shared = _signatures(gone).keys() & _signatures(came).keys()
    if not shared:
        return
    descriptions = {signature[0] for signature in shared}
    before, after = _signatures(search.old.nodes, descriptions), _signatures(search.new.nodes, descriptions)
    targets = {
        before[signature].copy().pop(): after[signature].copy().pop()
        for signature in shared
        if len(before[signature]) == len(after[signature]) == 1
    }
    for instance, path in search.old_paths.items():
        if path not in gone or instance.template not in targets:
            continue
        target = search.new_paths.get(Instance(targets[instance.template], instance.names))
        if target in came and target not in search.taken:
            _record(search, path, target, "same definition")


Signature = tuple[str, ...]


def _signatures(nodes: Nodes, descriptions: set[str] | None = None) -> dict[Signature, set[str]]:
    """For every definition of a signal, the templates that have it; only those with such a description, if given."""
    seen: set[int] = set()
    found: dict[Signature, set[str]] = {}
    for node in nodes.values():
        if id(node.definition) in seen:
            continue
        seen.add(id(node.definition))
        description = node.values.get("description")
        words = " ".join(description.split()) if isinstance(description, str) and node.is_leaf else ""
        if words and (descriptions is None or words in descriptions):
            found.setdefault(_signature(words, node.values), set()).add(node.template)
    return found


def _signature(words: str, values: Mapping[str, Any]) -> Signature:
    """Return the identity of a signal. Signals without a description have none: too many are alike."""
    facts = (values.get(name) for name in ("type", "datatype", "min", "max", "allowed", "enum", "arraysize"))
    return (words, str(values.get("unit")).lower(), *map(repr, facts))


def _gather_branches(search: _Search) -> None:
    """Branches of which every child moved, under its name, to one new branch; the deepest first."""
    for path in reversed(tuple(search.gone)):
        children = search.gone[path].children
        if path in search.moves or not children:
            continue
        moves = [search.moves.get(child.path) for child in children]
        target = parent_path(moves[0].target) if moves[0] is not None else ""
        expected = [f"{target}.{child.name}" for child in children]
        is_alike = [move.target if move else "" for move in moves] == expected
        if is_alike and target in search.came and target not in search.taken:
            evidences = {move.evidence for move in moves if move is not None}
            search.moves[path] = Move(target, evidences.pop() if len(evidences) == 1 else "same definition")
            search.taken.add(target)
