"""Merge layers: which statements speak of which node, in the order in which they apply."""

from collections.abc import Collection, Iterable, Mapping
from fnmatch import translate
from re import compile as compile_pattern
from typing import NamedTuple

from sigcat import codes
from sigcat.catalogue.composing.fold import define
from sigcat.catalogue.model.definition import Definition, Scope
from sigcat.catalogue.reading.layers import Layer
from sigcat.catalogue.reading.vspec_file import Statement
from sigcat.findings import Finding
from sigcat.limits import DEFAULT_LIMITS, Limits

Stacks = dict[str, tuple[Statement, ...]]
"""For every path, the statements of it from the first layer to the last."""
_LEAST_COMPARED = 20_000
"""Characters as which a wildcard path counts at least: it has to be made ready, however few paths there are."""


class Merged(NamedTuple):
    """Definitions by path, in the order in which the paths were first written."""

    definitions: Mapping[str, Definition]
    findings: tuple[Finding, ...]


def merge(
    layers: Iterable[Layer],
    scope: Scope,
    known: Mapping[str, Definition] | None = None,
    limits: Limits = DEFAULT_LIMITS,
) -> Merged:
    """Merge layers in order; later statements win, attribute by attribute.

    `known` are definitions of an earlier merge within the same scope: a node of which the same statements speak
    keeps its definition, so that a change of one overlay costs little.
    """
    stacks: Stacks = {}
    findings: list[Finding] = []
    for layer in layers:
        _pile(layer, stacks, limits, findings)
    known = known or {}
    definitions = {path: _definition(path, stack, scope, known.get(path)) for path, stack in stacks.items()}
    return Merged(definitions, tuple(findings))


def merge_over(below: Mapping[str, Definition], layer: Layer, scope: Scope, limits: Limits = DEFAULT_LIMITS) -> Merged:
    """One more layer over definitions that are merged already: those of which it speaks, and no others."""
    needed = below if _patterns(layer) else [each.path for each in layer.statements if each.path in below]
    stacks: Stacks = {path: below[path].statements for path in needed}
    findings: list[Finding] = []
    touched = _pile(layer, stacks, limits, findings)
    return Merged({path: define(path, stacks[path], scope) for path in touched}, tuple(findings))


def _pile(layer: Layer, stacks: Stacks, limits: Limits, findings: list[Finding]) -> Iterable[str]:
    """Put the statements of a layer on those below; the result are the paths of which it speaks, in its order."""
    touched: dict[str, None] = {}
    beyond = _beyond_limit(layer, stacks, limits, findings)
    for statement in layer.statements:
        if statement in beyond:
            continue
        for path in _paths(statement, stacks, findings):
            stacks[path] = (*stacks[path], statement) if path in stacks else (statement,)
            touched[path] = None
    return touched


def _beyond_limit(layer: Layer, stacks: Stacks, limits: Limits, findings: list[Finding]) -> Collection[Statement]:
    """The wildcard paths of a layer that are too many for the paths that they would be compared with."""
    patterns = _patterns(layer)
    if not patterns:
        return ()
    written = sum(len(statement.path) for statement in layer.statements if "*" not in statement.path)
    each = max(_LEAST_COMPARED, sum(map(len, stacks)) + written)
    most = limits.compared // each
    if len(patterns) <= most:
        return ()
    first = patterns[most]
    message = f"There are {len(patterns):,} wildcard paths; the limit is {most:,} for as many paths as there are."
    fix = "Name the nodes, or split the overlay."
    findings.append(codes.TOO_MANY_WILDCARDS.finding(message, *first.origin()[:3], first.path, fix=fix))
    return frozenset(patterns[most:])


def _patterns(layer: Layer) -> list[Statement]:
    """The statements of a layer that speak of every node that a wildcard path matches."""
    return [statement for statement in layer.statements if "*" in statement.path]


def _definition(path: str, stack: tuple[Statement, ...], scope: Scope, known: Definition | None) -> Definition:
    if known is not None and known.statements == stack:
        return known
    return define(path, stack, scope)


def _paths(statement: Statement, stacks: Stacks, findings: list[Finding]) -> Iterable[str]:
    """The path of a statement; for a pattern such as `Vehicle.*.Speed`, every path so far that it matches."""
    if "*" not in statement.path:
        return (statement.path,)
    matches = compile_pattern(translate(statement.path)).match
    paths = [path for path in stacks if matches(path)]
    if not paths:
        message = f"Pattern {statement.path!r} matches no node."
        fix = "Correct the pattern, or remove it."
        findings.append(codes.GLOB_MATCHES_NOTHING.finding(message, *statement.origin()[:3], statement.path, fix=fix))
    return paths
