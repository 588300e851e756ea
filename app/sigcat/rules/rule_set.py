"""The rules that run, made ready once for however many texts they check: their checks found, their options tried."""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from fnmatch import translate
from functools import cache, cached_property
from typing import NamedTuple

from sigcat import codes
from sigcat.catalogue.composing.compose import compose
from sigcat.catalogue.model.definition import Definition
from sigcat.findings import Finding, Severity
from sigcat.names import did_you_mean
from sigcat.patterns import BadPattern
from sigcat.rules.checks import CHECKS
from sigcat.rules.checks.attributes import extended_attributes
from sigcat.rules.checks.kind import BadOption, Check, LineCheck, LineTest, NodeCheck, TreeCheck, check_options
from sigcat.rules.record import Rule, option_position
from sigcat.rules.record_faults import MAKERS
from sigcat.rules.tree import Tree


class NodeRule(NamedTuple):
    """A rule whose check looks at one node at a time: `needs` are attributes without which it finds nothing."""

    rule: Rule
    check: NodeCheck
    needs: tuple[str, ...]
    path: Callable[[str], object] | None
    is_for_all: bool
    """Whether it is about nodes of any datatype, at any path, of trees and overlays."""

    def concerns(self, definition: Definition) -> bool:
        """Whether the datatype, the path and the first file of a node are those that the rule is about."""
        nodes = self.rule.nodes
        return (
            (not nodes.datatypes or str(definition.values.get("datatype")) in nodes.datatypes)
            and (self.path is None or bool(self.path(definition.path)))
            and (not nodes.is_of_overlay or definition.is_added)
        )


class Selection(NamedTuple):
    """The rules for nodes of one type and category: those for all of them, and those for nodes with an attribute."""

    always: Sequence[NodeRule]
    by_need: Mapping[str, Sequence[NodeRule]]


class RuleSet:
    """Rules that run. One whose options do not fit its check does not run and has a finding."""

    def __init__(self, rules: Iterable[Rule]) -> None:
        self.rules = tuple(rules)
        self.codes = tuple(rule.id for rule in self.rules)
        self.severities: Mapping[str, Severity] = {rule.id: rule.severity for rule in self.rules}
        self.of_composition = {rule.id: rule.severity for rule in self.rules if rule.check == "composition"}
        """Severities of findings of composing a catalogue."""
        self.node_rules: list[NodeRule] = []
        self.tree_rules: list[tuple[Rule, TreeCheck]] = []
        self.line_rules: list[tuple[Rule, LineTest]] = []
        self._types = {name for rule in self.rules for name in rule.nodes.types}
        self._selections: dict[tuple[str, str, bool], Selection] = {}
        self.findings = tuple(found for rule in self.rules if (found := self._take(rule)) is not None)
        """Findings about rules that cannot be used (L010)."""

    @cached_property
    def attributes(self) -> frozenset[str]:
        """Names of extended attributes that the tables of these rules define."""
        return extended_attributes(self.rules)

    def select(self, node_type: str, category: str, *, has_overlays: bool) -> Selection:
        """The rules for nodes of a type and category; rules about changes by overlays only if there are overlays."""
        key = (node_type if node_type in self._types else "", category, has_overlays)
        if key not in self._selections:
            usable = (each for each in self.node_rules if has_overlays or not each.check.of_overlays)
            self._selections[key] = _selection(each for each in usable if _concerns(each.rule, *key[:2]))
        return self._selections[key]

    @cached_property
    def of_whole_trees(self) -> frozenset[str]:
        """Codes of the rules that check a whole tree: on a partial tree they give false positives."""
        return frozenset(rule.id for rule in self.rules if _needs_whole_tree(rule))

    @cached_property
    def for_parts(self) -> "RuleSet":
        """The rules that can check a part of a tree alone."""
        return RuleSet(rule for rule in self.rules if rule.id not in self.of_whole_trees)

    @cached_property
    def counted(self) -> frozenset[str]:
        """Codes of the rules that one habit of a file breaks at many places: reports count those."""
        return frozenset(rule.id for rule in self.rules if rule.check == "known-attributes")

    @cached_property
    def without_stacks(self) -> "RuleSet":
        """The rules for one overlay over its tree: those on how several act together say nothing of it."""
        return RuleSet(rule for rule in self.rules if not _is_of_stacks(rule))

    def _take(self, rule: Rule) -> Finding | None:
        """Put a rule where its check belongs; a finding if it cannot be used."""
        if rule.check in MAKERS:
            return None
        try:
            check = _check_of(rule)
            if isinstance(check, NodeCheck | TreeCheck) and not rule.trusted:
                check.prepare(rule, _no_tree())
            if isinstance(check, NodeCheck):
                self.node_rules.append(_node_rule(rule, check))
            elif isinstance(check, TreeCheck):
                self.tree_rules.append((rule, check))
            elif isinstance(check, LineCheck):
                self.line_rules.append((rule, check.prepare(rule)))
        except (BadOption, BadPattern) as error:
            fix = error.fix if isinstance(error, BadOption) else ""
            at = option_position(rule, error.option if isinstance(error, BadOption) else "")
            return codes.RULE_UNUSABLE.finding(str(error), rule.file, *at, rule.id, fix=fix)
        return None


def _needs_whole_tree(rule: Rule) -> bool:
    check = CHECKS.get(rule.check)
    return rule.scope == "tree" or (check is not None and check.needs_whole_tree)


def _is_of_stacks(rule: Rule) -> bool:
    check = CHECKS.get(rule.check)
    return check is not None and check.of_stacks


@cache
def _no_tree() -> Tree:
    """A tree without nodes, on which the options of a check are tried; those of shipped rules are known to be good."""
    return Tree(compose([]))


def _check_of(rule: Rule) -> Check:
    check = CHECKS.get(rule.check)
    if check is None:
        fix = did_you_mean(rule.check, CHECKS) or f"Use one of {', '.join(sorted(CHECKS))}."
        raise BadOption(f"Unknown check {rule.check!r} of rule {rule.id}.", fix)
    if not rule.trusted:
        check_options(rule, check)
    return check


def _node_rule(rule: Rule, check: NodeCheck) -> NodeRule:
    needs = check.needs[1:] if check.needs.startswith("=") else str(rule.options.get(check.needs, ""))
    path = _matcher(rule.nodes.path) if rule.nodes.path else None
    names = tuple(name.partition(".")[0] for name in needs.split("|") if name)
    return NodeRule(rule, check, names, path, path is None and not (rule.nodes.datatypes or rule.nodes.is_of_overlay))


@cache
def _matcher(glob: str) -> Callable[[str], object]:
    return re.compile(translate(glob)).match


def _selection(rules: Iterable[NodeRule]) -> Selection:
    by_need: dict[str, list[NodeRule]] = {}
    for each in rules:
        for name in each.needs or ("",):
            by_need.setdefault(name, []).append(each)
    return Selection(by_need.pop("", []), by_need)


def _concerns(rule: Rule, node_type: str, category: str) -> bool:
    nodes = rule.nodes
    return (not nodes.types or node_type in nodes.types) and (not nodes.interfaces or category in nodes.interfaces)
