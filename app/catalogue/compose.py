"""Compose a catalogue: layers in, a frozen tree and findings out."""

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path

from app.catalogue.definition import BRANCH, STRUCT, Definition, Scope, checked
from app.catalogue.instances import Draft, TooManyNodes, expand
from app.catalogue.layers import Layer, read_layer
from app.catalogue.limits import DEFAULT_LIMITS, Limits
from app.catalogue.merge import merge
from app.catalogue.model import Catalogue, Node
from app.catalogue.vocabulary import EMPTY, Vocabulary, default_files, read_vocabulary
from app.catalogue.yaml_document import collector_paused
from app.findings import Finding, in_order
from app.names import last_name, parent_path


def read_catalogue(
    spec: Path,
    overlays: Sequence[Path] = (),
    *,
    include_dirs: Sequence[Path] = (),
    units: Sequence[Path] = (),
    quantities: Sequence[Path] = (),
    types: Sequence[Path] = (),
    name: str = "",
    expanded: bool = True,
    limits: Limits = DEFAULT_LIMITS,
) -> Catalogue:
    """Read a tree from files and compose it. Options have the meaning of those of `vspec export`."""
    vocabulary = read_vocabulary(
        default_files(spec, units, "units.yaml"), default_files(spec, quantities, "quantities.yaml"), limits
    )
    base = read_layer(spec, include_dirs, limits=limits)
    layers = [read_layer(path, include_dirs, is_overlay=True, limits=limits) for path in overlays]
    type_layers = [read_layer(path, include_dirs, limits=limits) for path in types]
    return compose(
        [base, *layers], vocabulary, type_layers, name=name or spec.stem, expanded=expanded, limits=limits
    )


def compose(
    layers: Sequence[Layer],
    vocabulary: Vocabulary = EMPTY,
    types: Sequence[Layer] = (),
    *,
    name: str = "",
    expanded: bool = True,
    limits: Limits = DEFAULT_LIMITS,
    earlier: Catalogue | None = None,
) -> Catalogue:
    """Compose layers, the base first, into a catalogue. Everything wrong is among its findings.

    With `earlier`, a catalogue of the same vocabulary and types, definitions that did not change are taken from it.
    """
    with collector_paused():
        return _compose(layers, vocabulary, types, name, expanded, limits, earlier)


def _compose(
    layers: Sequence[Layer],
    vocabulary: Vocabulary,
    types: Sequence[Layer],
    name: str,
    expanded: bool,
    limits: Limits,
    earlier: Catalogue | None,
) -> Catalogue:
    findings: list[Finding] = [*vocabulary.findings]
    for layer in (*layers, *types):
        findings.extend(layer.findings)
    type_root, scope = _type_tree(types, vocabulary, limits, findings)
    same_scope = earlier is not None and earlier.vocabulary is vocabulary and not types
    merged = merge(layers, scope, earlier.definitions if earlier is not None and same_scope else None)
    findings.extend(merged.findings)
    root = draft_tree(merged.definitions, scope, limits, findings)
    if root is not None and expanded:
        root = _expand(root, scope, limits, findings)
    roots = tuple(_finished(draft, findings) for draft in (root, type_root) if draft is not None)
    every_layer = (*layers, *types)
    return Catalogue(name, roots, vocabulary, every_layer, in_order(findings), merged.definitions, expanded)


def draft_tree(
    definitions: Mapping[str, Definition], scope: Scope, limits: Limits, findings: list[Finding]
) -> Draft | None:
    """Put definitions into a tree. A branch that nobody defined is made, with a finding."""
    usable = [path for path in definitions if _usable_path(path, definitions[path], limits, findings)]
    usable.sort(key=lambda path: path.count("."))
    roots = [path for path in usable if "." not in path]
    if not roots:
        if definitions:
            first = next(iter(definitions.values()))
            message = "The tree has no root: every path has a branch above it that is not defined."
            findings.append(Finding("V022", "error", message, *first.origin()[:3], first.path))
        return None
    for extra in roots[1:]:
        message = f"The tree has a second root {extra!r} beside {roots[0]!r}."
        findings.append(Finding("V021", "error", message, *definitions[extra].origin()[:3], extra))
    placed: dict[str, Draft] = {}
    orphans: list[str] = []
    for path in usable:
        draft = Draft(last_name(path), definitions[path], {})
        placed[path] = draft
        parent = parent_path(path)
        if parent in placed:
            _children(placed[parent])[draft.name] = draft
        elif "." in path:
            orphans.append(path)
    for path in orphans:
        _connect(path, placed, roots[0], scope, findings)
    return placed[roots[0]]


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
    findings.append(Finding("V024", "error", message, *definition.origin()[:3], path))
    return False


def _connect(
    path: str, placed: dict[str, Draft], root: str, scope: Scope, findings: list[Finding]
) -> None:
    """Hang a node whose parent nobody defined into the tree, with branches made for the missing ones."""
    first = placed[path].definition
    missing: list[str] = []
    child = placed[path]
    parent = parent_path(path)
    while parent and parent not in placed:
        missing.append(parent)
        definition = checked(parent, first.statements[:1], {"type": BRANCH}, scope)
        placed[parent] = Draft(last_name(parent), definition, {child.name: child})
        child, parent = placed[parent], parent_path(parent)
    if parent:
        _children(placed[parent])[child.name] = child
    for branch in reversed(missing):
        message = f"Branch {branch!r} is not defined; it is made because {path!r} stands below it."
        fix = f"Define {branch!r} with `type: branch` and a description."
        findings.append(Finding("V020", "warning", message, *first.origin()[:3], branch, fix=fix))
    if not parent and child.name != root:
        message = f"{path!r} stands under no root of the tree."
        findings.append(Finding("V022", "error", message, *first.origin()[:3], path))


def _expand(root: Draft, scope: Scope, limits: Limits, findings: list[Finding]) -> Draft:
    try:
        return expand(root, scope, limits)
    except TooManyNodes as error:
        definition = error.draft.definition
        message = f"Instances make {error.count:,} nodes; the limit is {limits.nodes:,}. Nothing is expanded."
        findings.append(Finding("V025", "error", message, *definition.origin("instances")[:3], definition.path))
        return root


def _type_tree(
    types: Sequence[Layer], vocabulary: Vocabulary, limits: Limits, findings: list[Finding]
) -> tuple[Draft | None, Scope]:
    """The tree of struct types, and the scope in which signals may use them."""
    if not types:
        return None, Scope(vocabulary)
    paths = merge(types, Scope(vocabulary)).definitions
    structs = {path: {} for path, d in paths.items() if d.type == STRUCT}  # type: dict[str, dict[str, Definition]]
    merged = merge(types, Scope(vocabulary, structs))
    for path, definition in merged.definitions.items():
        if parent_path(path) in structs:
            structs[parent_path(path)][last_name(path)] = definition
    findings.extend(merged.findings)
    scope = Scope(vocabulary, structs)
    return draft_tree(merged.definitions, scope, limits, findings), scope


def _finished(root: Draft, findings: list[Finding]) -> Node:
    """The draft as frozen nodes, without what is to be deleted; the problems of every definition are told once."""
    told: set[int] = set()
    return _node(root, root.name, None, told, findings)


def _node(draft: Draft, path: str, above: Definition | None, told: set[int], findings: list[Finding]) -> Node:
    definition = draft.definition
    if id(definition) not in told:
        told.add(id(definition))
        findings.extend(definition.finding(problem, path) for problem in definition.problems)
        findings.extend(_misplaced(definition, path, above))
    prefix = path + "."
    children = tuple(
        [
            _node(child, prefix + child.name, definition, told, findings)
            for child in draft.children.values()
            if not child.definition.values.get("delete")
        ]
    )
    return Node(path, definition, children)


def _misplaced(definition: Definition, path: str, above: Definition | None) -> Iterable[Finding]:
    """A finding if the node may not stand below the one above it."""
    if above is None or not definition.type or not above.type:
        return
    allowed = {"property": (STRUCT,), STRUCT: (STRUCT, BRANCH)}.get(definition.type, (BRANCH,))
    if above.type not in allowed:
        message = f"A node of type {definition.type} cannot stand below one of type {above.type}."
        fix = f"Only {' or '.join(allowed)} can have it below."
        yield Finding("V019", "error", message, *definition.origin("type")[:3], path, fix=fix)
