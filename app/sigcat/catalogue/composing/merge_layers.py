"""Merge layers: collect the statements about each node, base first and overlays in their order, and define the node.

Later statements win, attribute by attribute.
"""

from collections.abc import Collection, Iterable, Mapping
from fnmatch import translate
from itertools import groupby
from re import compile as compile_pattern
from typing import NamedTuple

from sigcat import codes
from sigcat.catalogue.composing.blame import with_blame
from sigcat.catalogue.composing.check_definition import checked_definition
from sigcat.catalogue.model.definition import Definition, Scope, merged_statements
from sigcat.catalogue.reading.layers import Layer
from sigcat.catalogue.reading.statement import Statement
from sigcat.findings import Finding
from sigcat.limits import DEFAULT_LIMITS, Limits

Stacks = dict[str, tuple[Statement, ...]]
"""For every path, the statements about it, from the first layer to the last."""
_LEAST_COMPARED = 20_000
"""Characters that a wildcard path counts for at least: compiling it costs time, however few paths there are."""


class Merged(NamedTuple):
    """Definitions by path, in the order in which the paths were first written."""

    definitions: Mapping[str, Definition]
    findings: tuple[Finding, ...]


def merge_layers(
    layers: Iterable[Layer],
    scope: Scope,
    known: Mapping[str, Definition] | None = None,
    limits: Limits = DEFAULT_LIMITS,
) -> Merged:
    """Merge layers in order.

    `known` are definitions of an earlier merge in the same scope: a node with the same statements keeps its
    definition, so that a change of one overlay costs little.
    """
    stacks: Stacks = {}
    findings: list[Finding] = []
    for layer in layers:
        _add_statements(layer, stacks, limits, findings)
    known = known or {}
    definitions = {path: _definition(path, stack, scope, known.get(path)) for path, stack in stacks.items()}
    return Merged(definitions, tuple(findings))


def merge_over(below: Mapping[str, Definition], layer: Layer, scope: Scope, limits: Limits = DEFAULT_LIMITS) -> Merged:
    """Merge one more layer over merged definitions. The result has the nodes that the layer has statements about."""
    needed = below if _patterns(layer) else [each.path for each in layer.statements if each.path in below]
    stacks: Stacks = {path: below[path].statements for path in needed}
    findings: list[Finding] = []
    changed = _add_statements(layer, stacks, limits, findings)
    return Merged({path: define_node(path, stacks[path], scope) for path in changed}, tuple(findings))


def define_node(path: str, statements: tuple[Statement, ...], scope: Scope) -> Definition:
    """Merge the statements about one node, first to last, into a checked definition."""
    definition = checked_definition(path, statements, merged_statements(statements), scope)
    if not definition.problems or len(statements) == 1:
        return definition
    return with_blame(definition, define_node(path, statements[:-1], scope), scope)


def _add_statements(layer: Layer, stacks: Stacks, limits: Limits, findings: list[Finding]) -> Iterable[str]:
    """Put the statements of a layer on top of those below; the paths that they are about, in the layer's order."""
    changed: dict[str, None] = {}
    beyond = _beyond_limit(layer, stacks, limits, findings)
    for _, of_file in groupby(layer.statements, key=lambda statement: id(statement.file)):
        said = {
            path: statement
            for statement in of_file
            if statement not in beyond
            for path in _paths(statement, stacks, findings)
        }
        for path, statement in said.items():
            stacks[path] = (*stacks[path], statement) if path in stacks else (statement,)
            changed[path] = None
    return changed


def _beyond_limit(layer: Layer, stacks: Stacks, limits: Limits, findings: list[Finding]) -> Collection[Statement]:
    """The wildcard paths of a layer that are over the limit; the limit depends on how much they are compared with."""
    patterns = _patterns(layer)
    if not patterns:
        return ()
    written = sum(len(statement.path) for statement in layer.statements if "*" not in statement.path)
    each = max(_LEAST_COMPARED, sum(map(len, stacks)) + written)
    most = limits.compared // each
    if len(patterns) <= most:
        return ()
    first = patterns[most]
    message = f"There are {len(patterns):,} wildcard paths; the limit for a tree of this size is {most:,}."
    fix = "Name the nodes, or split the overlay."
    findings.append(codes.TOO_MANY_WILDCARDS.finding(message, *first.origin().position, first.path, fix=fix))
    return frozenset(patterns[most:])


def _patterns(layer: Layer) -> list[Statement]:
    """The statements of a layer with wildcard paths: each is about every node that its path matches."""
    return [statement for statement in layer.statements if "*" in statement.path]


def _definition(path: str, stack: tuple[Statement, ...], scope: Scope, known: Definition | None) -> Definition:
    if known is not None and known.statements == stack:
        return known
    return define_node(path, stack, scope)


def _paths(statement: Statement, stacks: Stacks, findings: list[Finding]) -> Iterable[str]:
    """The path of a statement; for a wildcard path such as `Vehicle.*.Speed`, every path of the files before that it matches.

    In the first file of a tree there are none, and vss-tools takes the path as it is.
    """
    if "*" not in statement.path or not stacks:
        return (statement.path,)
    matches = compile_pattern(translate(statement.path)).match
    paths = [path for path in stacks if matches(path)]
    if not paths:
        message = f"Pattern {statement.path!r} matches no node."
        fix = "Correct the pattern, or remove it."
        findings.append(
            codes.GLOB_MATCHES_NOTHING.finding(message, *statement.origin().position, statement.path, fix=fix)
        )
    return paths
