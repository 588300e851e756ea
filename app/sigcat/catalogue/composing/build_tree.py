"""Build the tree: definitions by path in, a draft of the tree out, and in the end a draft frozen into nodes."""

from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

from sigcat import codes
from sigcat.catalogue.composing.instance_names import levels_of_instances
from sigcat.catalogue.model.catalogue import Node
from sigcat.catalogue.model.definition import BRANCH, STRUCT, TYPES, Definition, Problem
from sigcat.findings import Finding
from sigcat.limits import Limits
from sigcat.names import did_you_mean, last_name, nearest, parent_path, with_article


class Draft(NamedTuple):
    """A node while the tree is built: its instances not yet expanded, its children not yet final."""

    name: str
    definition: Definition
    children: Mapping[str, "Draft"]


def draft_tree(definitions: Mapping[str, Definition], limits: Limits, findings: list[Finding]) -> Draft | None:
    """The tree of the first root, or None if there is no root. Branches that no file defines are added."""
    written = [path for path in definitions if _is_usable(path, definitions[path], limits, findings)]
    usable = sorted(written, key=lambda path: path.count("."))
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
    first_below = _first_below(written, placed) if orphans else {}
    for path in orphans:
        _connect(path, placed, first_below, definitions, root, findings)
    return placed[root] if root else None


def frozen_tree(root: Draft, findings: list[Finding]) -> Node:
    """The draft as nodes, without those to delete. The problems of each definition are reported once."""
    return _node(root, root.name, None, set(), findings)


def _children(draft: Draft) -> dict[str, Draft]:
    """The children of a draft that is still being filled."""
    children = draft.children
    assert isinstance(children, dict)
    return children


def _is_usable(path: str, definition: Definition, limits: Limits, findings: list[Finding]) -> bool:
    names = path.split(".")
    position = definition.origin().position
    if "" in names:
        message = f"Path {path!r} has an empty name."
        findings.append(codes.PATH_MALFORMED.finding(message, *position, path, fix="Remove the extra dot."))
    if len(names) <= limits.path_names:
        return True
    message = f"The path has {len(names)} names; the limit is {limits.path_names}."
    findings.append(codes.NESTING_TOO_DEEP.finding(message, *position, path))
    return False


_TYPES_FILE = "Struct types are not an overlay: list the file as `types` in sigcat.toml, or pass it with `-t`."


def _single_root(paths: list[str], definitions: Mapping[str, Definition], findings: list[Finding]) -> str:
    roots = [path for path in paths if "." not in path]
    if not roots and paths:
        message = "The tree has no root: every path has a dot."
        fix = "Define the root as a branch; for an overlay, name the tree that it extends."
        origin = definitions[paths[0]].origin()
        findings.append(codes.OUTSIDE_ROOT.finding(message, *origin.position, paths[0], fix=fix))
    for extra in roots[1:]:
        message = f"The tree has a second root, {extra!r} beside {roots[0]!r}."
        has_structs = any(
            definitions[path].values.get("type") == "struct" for path in paths if path.startswith(f"{extra}.")
        )
        fix = _TYPES_FILE if has_structs else _without_slashes(extra) or f"Move it below {roots[0]!r}, or remove it."
        findings.append(codes.SECOND_ROOT.finding(message, *definitions[extra].origin().position, extra, fix=fix))
    return roots[0] if roots else ""


def _without_slashes(name: str) -> str:
    """Return the fix of a path that is written with slashes; empty for others."""
    return f"Write {name.strip('/').replace('/', '.')!r}." if "/" in name else ""


def _first_below(written: Iterable[str], placed: Mapping[str, Draft]) -> Mapping[str, str]:
    """For each branch that no file defines, the path below it that was written first: in the tree, before any overlay."""
    first: dict[str, str] = {}
    for path in written:
        above = parent_path(path)
        while above and above not in first:
            if above not in placed:
                first[above] = path
            above = parent_path(above)
    return first


def _connect(
    path: str,
    placed: dict[str, Draft],
    first_below: Mapping[str, str],
    definitions: Mapping[str, Definition],
    root: str,
    findings: list[Finding],
) -> None:
    """Connect a node whose parent no file defines to the tree, with branches added for the missing ones."""
    definition = placed[path].definition
    child, parent = placed[path], parent_path(path)
    while parent and parent not in placed:
        below = first_below[parent]
        added = _added_branch(parent, below, definitions[below], placed.get(parent_path(parent)))
        placed[parent] = Draft(last_name(parent), added, {child.name: child})
        child, parent = placed[parent], parent_path(parent)
    if parent:
        _children(placed[parent])[child.name] = child
    elif root:
        message = f"{path!r} is outside of the tree, whose root is {root!r}."
        first, _, rest = path.partition(".")
        fix = f"Write '{root}.{rest}'." if nearest(first, [root]) and rest else f"Move it below {root!r}."
        findings.append(codes.OUTSIDE_ROOT.finding(message, *definition.origin().position, path, fix=fix))


def _added_branch(path: str, below: str, definition: Definition, above: Draft | None) -> Definition:
    message = f"Branch {path!r} is not defined, but {below!r} is below it."
    beside = [child.name for child in above.children.values() if child.definition.type == BRANCH] if above else []
    fix = fix_of_undefined(path, did_you_mean(last_name(path), beside))
    problem = Problem(codes.BRANCH_UNDEFINED, "", message, fix)
    is_named = "" not in below.split(".")  # else the finding about the malformed path is enough
    return Definition(path, definition.statements[:1], {"type": BRANCH}, (problem,) if is_named else ())


def fix_of_undefined(branch: str, proposal: str) -> str:
    """Return the fix for a branch that is not defined, where something else may have been meant."""
    return f"{proposal} Define {branch!r} with `type: branch` and a description.".lstrip()


# -- freezing -----------------------------------------------------------------------------------------------------


def _node(draft: Draft, path: str, above: Definition | None, reported: set[int], findings: list[Finding]) -> Node:
    definition = draft.definition
    if id(definition) not in reported:
        reported.add(id(definition))
        if definition.problems or (above is not None and (above.type != BRANCH or definition.type in _BELOW_FEW)):
            findings.extend(_findings(definition, path, above))
    if not draft.children:
        return Node(path, definition, ())
    prefix = path + "."
    children = []
    for name, child in draft.children.items():
        child_path = _shared(prefix + name, child.definition.path)
        if child.definition.values.get("delete"):
            findings.extend(_findings_of_deleted(child, child_path, definition, reported))
        else:
            children.append(_node(child, child_path, definition, reported, findings))
    return Node(path, definition, tuple(children))


def _findings_of_deleted(draft: Draft, path: str, above: Definition, reported: set[int]) -> Iterator[Finding]:
    """Yield the problems of a node before it is deleted: vss-tools refuses it too, with the exceptions below."""
    found: list[Finding] = []
    _node(draft, path, above, reported, found)
    return (finding for finding in found if finding.rule not in _ONLY_OF_WHAT_STAYS)


_ONLY_OF_WHAT_STAYS = frozenset((codes.ATTRIBUTE_WITHOUT_MEANING.id, codes.NODE_BELOW_SIGNAL.id))
"""vss-tools checks these in the tree that is left after deletion."""
_BELOW_FEW = frozenset(("property", STRUCT))
"""Types that may not be below every branch."""
_PARENTS: Mapping[str, tuple[str, ...]] = {"property": (STRUCT,), STRUCT: (STRUCT, BRANCH)}
"""Types that a parent may have, by the type of the child; of other children, the parent is a branch."""


def _shared(path: str, known: str) -> str:
    """`path` as the object that is held already, if it is equal: most nodes are where they are defined."""
    return known if path == known else path


def _findings(definition: Definition, path: str, above: Definition | None) -> Iterable[Finding]:
    for problem in definition.problems:
        if problem.rule.id != codes.BRANCH_UNDEFINED.id or not _refines_an_instance(path, above):
            yield definition.finding(problem, path)
    if above is not None and definition.type in TYPES and above.type in TYPES:
        parents = _PARENTS.get(definition.type, (BRANCH,))
        if above.type not in parents:
            yield _misplaced(definition, path, above, parents)


def _refines_an_instance(path: str, above: Definition | None) -> bool:
    """Whether a branch that no file defines is an instance of the one above it."""
    return above is not None and last_name(path) in next(levels_of_instances(above.values), ())


def _misplaced(definition: Definition, path: str, above: Definition, parents: tuple[str, ...]) -> Finding:
    """A node below one of a wrong type. The finding points to the type that an overlay gave last, if one did."""
    if above.type in (BRANCH, STRUCT):
        needed = " or ".join(map(with_article, parents))
        message = f"{_capital(definition.type)} must be below {needed}, not below {with_article(above.type)}."
        fix = "Make it a property." if above.type == STRUCT else f"Make {above.path!r} {needed}."
    else:
        message = f"{_capital(above.type)} cannot have children."
        fix = f"Make {above.path!r} {with_article(parents[-1])}."
        if definition.origin().overlay and not above.origin("type").overlay:  # the node below is the mistake
            message = f"{path!r} is below {with_article(above.type)}, {above.path!r}."
            fix = f"Write {f'{parent_path(above.path)}.{last_name(path)}'!r}, or place it below another branch."
            return codes.NODE_BELOW_SIGNAL.finding(message, *definition.origin().position, path, fix=fix)
    own, others = definition.origin("type"), above.origin("type")
    if others.overlay and not own.overlay:  # one finding, however many nodes are below
        return codes.NODE_BELOW_SIGNAL.finding(message, *others.position, above.path, fix=fix)
    return codes.NODE_BELOW_SIGNAL.finding(message, *own.position, path, fix=fix)


def _capital(node_type: str) -> str:
    article_and_type = with_article(node_type)
    return article_and_type[:1].upper() + article_and_type[1:]
