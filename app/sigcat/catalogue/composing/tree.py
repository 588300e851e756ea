"""Put definitions into a tree, and freeze a tree into nodes."""

from collections.abc import Iterable, Iterator, Mapping

from sigcat import codes
from sigcat.catalogue.composing.instances import Draft
from sigcat.catalogue.model.catalogue import Node
from sigcat.catalogue.model.definition import BRANCH, STRUCT, Definition, Problem
from sigcat.findings import Finding
from sigcat.limits import Limits
from sigcat.names import did_you_mean, last_name, parent_path


def draft_tree(definitions: Mapping[str, Definition], limits: Limits, findings: list[Finding]) -> Draft | None:
    """The tree of the first root, or None if there is no root. A branch that nobody defined is made."""
    usable = [path for path in definitions if _usable_path(path, definitions[path], limits, findings)]
    usable.sort(key=lambda path: path.count("."))
    root = _single_root(usable, definitions, findings)
    placed: dict[str, Draft] = {}
    orphans: list[str] = []
    for path in usable:
        draft = placed[path] = Draft(last_name(path), definitions[path], {})
        parent = parent_path(path)
        if parent in placed:
            _children(placed[parent])[draft.name] = draft
        elif parent:
            orphans.append(path)
    for path in orphans:
        _connect(path, placed, root, findings)
    return placed[root] if root else None


def frozen_tree(root: Draft, findings: list[Finding]) -> Node:
    """The draft as frozen nodes, without what is to be deleted; the problems of each definition are told once."""
    return _node(root, root.name, None, set(), findings)


def _children(draft: Draft) -> dict[str, Draft]:
    """The children of a draft that is still being filled."""
    children = draft.children
    assert isinstance(children, dict)
    return children


def _usable_path(path: str, definition: Definition, limits: Limits, findings: list[Finding]) -> bool:
    names = path.split(".")
    if "" in names:
        message = f"Path {path!r} has an empty name."
    elif len(names) > limits.path_names:
        message = f"The path has {len(names)} names; the limit is {limits.path_names}."
    else:
        return True
    findings.append(codes.PATH_MALFORMED.finding(message, *definition.origin()[:3], path))
    return False


def _single_root(paths: list[str], definitions: Mapping[str, Definition], findings: list[Finding]) -> str:
    roots = [path for path in paths if "." not in path]
    if not roots and paths:
        message = "The tree has no root: no path is without a branch above it."
        fix = "Define the root as a branch; of an overlay, name the tree that it goes over."
        findings.append(codes.OUTSIDE_ROOT.finding(message, *definitions[paths[0]].origin()[:3], paths[0], fix=fix))
    for extra in roots[1:]:
        message = f"The tree has a second root {extra!r} beside {roots[0]!r}."
        fix = f"Place it below {roots[0]!r}, or remove it."
        findings.append(codes.SECOND_ROOT.finding(message, *definitions[extra].origin()[:3], extra, fix=fix))
    return roots[0] if roots else ""


def _connect(path: str, placed: dict[str, Draft], root: str, findings: list[Finding]) -> None:
    """Hang a node whose parent nobody defined into the tree, with branches made for the missing ones."""
    definition = placed[path].definition
    child, parent = placed[path], parent_path(path)
    while parent and parent not in placed:
        made = _made_branch(parent, path, definition, placed.get(parent_path(parent)))
        placed[parent] = Draft(last_name(parent), made, {child.name: child})
        child, parent = placed[parent], parent_path(parent)
    if parent:
        _children(placed[parent])[child.name] = child
    elif root:
        message = f"{path!r} stands under no root of the tree."
        fix = f"Place it below {root!r}."
        findings.append(codes.OUTSIDE_ROOT.finding(message, *definition.origin()[:3], path, fix=fix))


def _made_branch(path: str, below: str, definition: Definition, above: Draft | None) -> Definition:
    message = f"Branch {path!r} is not defined; it is made because {below!r} stands below it."
    beside = [child.name for child in above.children.values() if child.definition.type == BRANCH] if above else []
    fix = f"{did_you_mean(last_name(path), beside)} Define {path!r} with `type: branch` and a description.".lstrip()
    rule = codes.BRANCH_UNDEFINED.graded("warning")  # composing goes on with the branch that is made here
    problem = Problem(rule, "", message, fix)
    return Definition(path, definition.statements[:1], {"type": BRANCH}, (problem,))


def _node(draft: Draft, path: str, above: Definition | None, told: set[int], findings: list[Finding]) -> Node:
    definition = draft.definition
    if id(definition) not in told:
        told.add(id(definition))
        if definition.problems or (above is not None and (above.type != BRANCH or definition.type in _BELOW_FEW)):
            findings.extend(_findings(definition, path, above))
    if not draft.children:
        return Node(path, definition, ())
    prefix = path + "."
    children = []
    for name, child in draft.children.items():
        place = _same(prefix + name, child.definition.path)
        if child.definition.values.get("delete"):
            findings.extend(_of_deleted(child, place, definition, told))
        else:
            children.append(_node(child, place, definition, told, findings))
    return Node(path, definition, tuple(children))


def _of_deleted(draft: Draft, path: str, above: Definition, told: set[int]) -> Iterator[Finding]:
    """What is wrong with a node before it is deleted: vss-tools refuses it, except for where it stands and what it has."""
    found: list[Finding] = []
    _node(draft, path, above, told, found)
    return (finding for finding in found if finding.rule not in _OF_WHAT_STAYS)


_OF_WHAT_STAYS = frozenset((codes.ATTRIBUTE_WITHOUT_MEANING.id, codes.NODE_BELOW_SIGNAL.id))
"""Attributes without meaning for the type, and the place below a type: judged of the tree that is left."""
_BELOW_FEW = frozenset(("property", STRUCT))
"""Types that do not stand below every branch, or below branches only."""


def _same(path: str, known: str) -> str:
    """`path` as the text that is held already, if it is equal: most nodes stand where they are defined."""
    return known if path == known else path


def _findings(definition: Definition, path: str, above: Definition | None) -> Iterable[Finding]:
    for problem in definition.problems:
        refines_an_instance = (
            problem.rule.id == codes.BRANCH_UNDEFINED.id and above is not None and above.values.get("instances")
        )
        if not refines_an_instance:
            yield definition.finding(problem, path)
    if above is not None and definition.type and above.type:
        allowed = {"property": (STRUCT,), STRUCT: (STRUCT, BRANCH)}.get(definition.type, (BRANCH,))
        if above.type not in allowed:
            message = f"A node of type {definition.type} cannot stand below one of type {above.type}."
            fix = f"Only {' or '.join(allowed)} can have it below."
            own, others = definition.origin("type"), above.origin("type")
            place = others if others.overlay and not own.overlay else own  # of the one that a layer above made so
            yield codes.NODE_BELOW_SIGNAL.finding(message, *place[:3], path, fix=fix)
