"""Lint a text that is in no file, such as the body of a request."""

from collections.abc import Sequence
from functools import partial

from sigcat import codes
from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.composing.compose_part import compose_part
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.vocabulary import EMPTY
from sigcat.catalogue.reading.layers import Layer, layer_from_text
from sigcat.file_kind import holds_function
from sigcat.findings import Finding, in_order
from sigcat.limits import DEFAULT_LIMITS, Limits
from sigcat.rules.engine import Found, found_in, lint_lines
from sigcat.rules.linting.context import with_instances
from sigcat.rules.linting.counted import counted
from sigcat.rules.linting.options import NO_OPTIONS, LintOptions
from sigcat.rules.linting.severity import Grading
from sigcat.rules.linting.suppression import MARK, apply_suppressions, read_suppressions
from sigcat.rules.rule_set import RuleSet


def lint_text(
    text: bytes,
    name: str,
    base: Catalogue | None,
    rules: RuleSet,
    *,
    is_tree: bool = False,
    limits: Limits = DEFAULT_LIMITS,
    options: LintOptions = NO_OPTIONS,
    known: frozenset[str] = frozenset(),
) -> tuple[Finding, ...]:
    """Findings in an overlay over `base`, or in a tree by itself. `name` is what findings call the text.

    `known` are codes of all existing rules: those that do not run are not reported.
    """
    refused = _refused(text, name, is_tree=is_tree)
    if refused is not None:
        return (refused,)
    layer = layer_from_text(text, name, is_overlay=not is_tree, limits=limits)
    if is_tree or base is None:
        found = _found_in_tree(layer, base, rules, limits, options.attributes)
    else:
        found = _found_in_overlay(layer, base, rules, limits, options.attributes)
    content = text.decode("utf-8-sig", "replace")
    findings = [finding for finding, _ in found if finding.file == name]
    findings.extend(finding for finding, _ in lint_lines(content, name, rules))
    suppressions = [read_suppressions(content, name, rules.codes)] if MARK in text else []
    grading = Grading(rules.severities, known, options)
    kept = apply_suppressions(in_order(list(grading.graded(findings))), suppressions, rules.codes)
    every = in_order((*kept.findings, *grading.graded(kept.about_comments)))
    return tuple(counted(every, rules.counted))


def _refused(text: bytes, name: str, *, is_tree: bool) -> Finding | None:
    """A text that is not vspec at all is one finding: everything in it would be wrong."""
    wanted = "a tree" if is_tree else "an overlay"
    if not text.strip():
        fix = f"Send the text of {wanted}."
        return codes.POSTED_TEXT_EMPTY.finding("The text must not be empty.", name, 1, 1, fix=fix)
    if holds_function(text):
        fix = "Check it with the kind `function`."
        return codes.FIELD_UNKNOWN.finding(f"The text must be {wanted}, not a function.", name, 1, 1, fix=fix)
    return None


def _found_in_tree(
    layer: Layer, base: Catalogue | None, rules: RuleSet, limits: Limits, attributes: Sequence[str]
) -> list[Found]:
    compose_text = partial(compose, [layer], base.vocabulary if base else EMPTY, limits=limits)
    catalogue = compose_text(expanded=False)
    expanded = with_instances(catalogue, catalogue.definitions.values(), compose_text)
    return list(found_in(expanded, rules, attributes=attributes))


def _found_in_overlay(
    layer: Layer, base: Catalogue, rules: RuleSet, limits: Limits, attributes: Sequence[str]
) -> list[Found]:
    """Only what the overlay changes is composed and checked; the whole tree only where instances need it."""
    layers = [*base.tree_layers, layer]
    whole = partial(compose, layers, base.vocabulary, base.type_layers, name=base.name, limits=limits, earlier=base)
    part = compose_part(base, layer, limits)
    judged = part.changed.values()
    return list(found_in(with_instances(part, judged, whole), rules, judged, attributes))
