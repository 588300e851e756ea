"""Effects of an overlay that is tried: nodes, changes by class, and the functions that use them."""

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from typing import NamedTuple

from sigcat.catalogue.comparing.changes import CLASSES
from sigcat.catalogue.comparing.trial import Trial, try_overlay
from sigcat.catalogue.model.catalogue import Catalogue, Node
from sigcat.findings import Finding, has_errors
from sigcat.function.function_json.model import FunctionJson
from sigcat.function.hosted_files import HostedFiles
from sigcat.function.hosting import HostedFunction, buildable, built_over, functions_over
from sigcat.function.node_uses import uses_in
from sigcat.limits import PAGE_FINDINGS, Limits
from sigcat.web.views.change_trees import Branch, trees_of, worst_first


class TriedNode(NamedTuple):
    """A node as it would be; one for all instances of a definition."""

    node: Node
    path: str
    is_new: bool
    places: int


class AffectedFunction(NamedTuple):
    """A function that uses what an overlay changes, or that builds only with it."""

    id: str
    name: str
    paths: tuple[str, ...]
    """Changed nodes that it uses."""
    built_before: bool
    builds: bool
    is_other: bool
    """Whether its Function JSON says something else than before."""
    findings: tuple[Finding, ...]
    """Findings that it did not have before."""


class OverlayOutcome(NamedTuple):
    """The effects of an overlay."""

    nodes: tuple[TriedNode, ...]
    """The first of them."""
    node_count: int
    trees: Sequence[tuple[str, Branch]]
    classes: tuple[tuple[str, int], ...]
    """Number of changes of each class that has some."""
    change_count: int
    functions: tuple[AffectedFunction, ...]


def overlay_outcome(text: bytes, catalogue: Catalogue, files: HostedFiles, limits: Limits) -> OverlayOutcome:
    """Return the effects of an overlay, given as text, on a catalogue and on the functions of a service."""
    trial = try_overlay(catalogue, text, "posted.vspec", limits)
    nodes = _tried_nodes(trial, catalogue)
    numbers = Counter(change.compatibility for change in trial.changes)
    return OverlayOutcome(
        nodes[:PAGE_FINDINGS],
        len(nodes),
        trees_of(worst_first(trial.changes)[:PAGE_FINDINGS]),
        tuple((name, numbers[name]) for name in CLASSES if numbers[name]),
        len(trial.changes),
        tuple(_affected(trial, catalogue, files)),
    )


def _tried_nodes(trial: Trial, catalogue: Catalogue) -> tuple[TriedNode, ...]:
    places = Counter(node.template for node in trial.nodes)
    firsts = {node.template: node for node in reversed(trial.nodes)}
    return tuple(
        TriedNode(node, node.path if places[path] == 1 else path, node.path not in catalogue.nodes, places[path])
        for path, node in reversed(firsts.items())
    )


def _affected(trial: Trial, catalogue: Catalogue, files: HostedFiles) -> Iterator[AffectedFunction]:
    used = _used_by_function(trial, catalogue, files)
    before = {each.id: each for each in functions_over(buildable(files, trial.catalogue), catalogue)}
    concerned = {*used, *_waiting(before.values(), trial)}
    if not concerned:
        return
    groups = {each.group for each in files if each.id in concerned}
    after = built_over(tuple(each for each in files if each.group in groups), trial.catalogue)
    for each in after:
        if each.id in concerned and each.id in before:
            yield _compared(before[each.id], each, used.get(each.id, ()))


def _used_by_function(trial: Trial, catalogue: Catalogue, files: HostedFiles) -> dict[str, tuple[str, ...]]:
    """The paths that each function uses, of nodes that change or go."""
    changed = {node.path for node in trial.nodes}
    found: dict[str, dict[str, None]] = {}
    for path, uses in uses_in(files, catalogue).of_node.items():
        if path in changed or path not in trial.catalogue.nodes:
            for use in uses:
                found.setdefault(use.function_id, {})[path] = None
    return {function_id: tuple(paths) for function_id, paths in found.items()}


def _waiting(functions: Iterable[HostedFunction], trial: Trial) -> Iterator[str]:
    """Functions that do not build, and miss a node which the overlay changes or adds."""
    changed = {node.path for node in trial.nodes}
    for each in functions:
        if each.function is None and any(finding.path in changed for finding in each.findings):
            yield each.id


def _compared(before: HostedFunction, after: HostedFunction, paths: tuple[str, ...]) -> AffectedFunction:
    known = {(finding.rule, finding.message) for finding in before.findings}
    fresh = tuple(each for each in after.findings if (each.rule, each.message) not in known)
    builds, built = not has_errors(after.findings), not has_errors(before.findings)
    name = after.name if builds else before.name
    return AffectedFunction(after.id, name, paths, built, builds, _content(before) != _content(after), fresh)


def _content(each: HostedFunction) -> FunctionJson | None:
    """Return the declaration of a function, whatever catalogue it was made from."""
    return each.function.model_copy(update={"provenance": None}) if each.function else None
