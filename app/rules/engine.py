"""The engine: rules and a catalogue in, findings out. Knows nothing of files, formats or the command line."""

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from fnmatch import translate
from functools import cache
from typing import Any, NamedTuple

from app.catalogue.definition import Definition
from app.catalogue.interfaces import category_of
from app.catalogue.model import Catalogue
from app.catalogue.patterns import BadPattern
from app.catalogue.vspec_file import Statement
from app.errors import InputRefused
from app.findings import Finding, in_order
from app.names import did_you_mean
from app.rules.checks import CHECKS
from app.rules.checks.attributes import extended_attributes
from app.rules.checks.kind import BadOption, Check, LineCheck, NodeCheck, NodeTest, TreeCheck, check_options
from app.rules.flaw import Flaw, Repair
from app.rules.patterns import SlowPattern
from app.rules.record import MAKERS, Rule
from app.rules.tree import Tree

_FIELD = re.compile(r"\{(\w+)(!r)?\}")

Found = tuple[Finding, Repair | None]
"""A finding, and the change of bytes that repairs it, if there is one."""


def lint_catalogue(catalogue: Catalogue, rules: Sequence[Rule]) -> tuple[Finding, ...]:
    """Every finding of `rules` in a catalogue, those of its composition among them, by file and line."""
    return in_order([finding for finding, _ in found_in(catalogue, rules)])


def found_in(
    catalogue: Catalogue,
    rules: Sequence[Rule],
    among: Iterable[Definition] | None = None,
    attributes: Iterable[str] = (),
) -> Iterator[Found]:
    """Findings with their repairs. `among` are the definitions that are looked at one by one; all without it.

    `attributes` are names of extended attributes that count as known, beside those of the rules' tables.
    """
    tree = Tree(catalogue, {*attributes, *extended_attributes(tuple(rules))})
    yield from _composition(catalogue, tree, rules)
    bound = bind(rules, tree)
    for finding in bound.findings:
        yield finding, None
    yield from _node_findings(bound.node_rules, tree, tree.definitions.values() if among is None else among)
    for rule, test in bound.tree_rules:
        yield from _guarded(rule, test())


def lint_lines(content: str, name: str, rules: Sequence[Rule]) -> Iterator[Finding]:
    """Findings of the rules that look at the text of a file."""
    for rule in rules:
        check = CHECKS.get(rule.check)
        if isinstance(check, LineCheck):
            for line, column, message, fix in check.prepare(rule)(content):
                yield Finding(rule.id, rule.severity, message, name, line, column, fix=fix)


class NodeRule(NamedTuple):
    """A rule with its check made ready: `needs` is the attribute without which it finds nothing."""

    rule: Rule
    test: NodeTest
    needs: str
    path: Callable[[str], object] | None
    of_overlays: bool

    def concerns(self, definition: Definition) -> bool:
        """Whether the datatype and the path of a node are those that the rule is about."""
        datatypes = self.rule.nodes.datatypes
        return (not datatypes or str(definition.values.get("datatype")) in datatypes) and (
            self.path is None or bool(self.path(definition.path))
        )


class _Choice(NamedTuple):
    """The rules for nodes of one type and category: those for all of them, and those for nodes with an attribute."""

    always: Sequence[NodeRule]
    by_need: Mapping[str, Sequence[NodeRule]]


class Bound(NamedTuple):
    """Rules with their checks made ready, and what was wrong with the others."""

    node_rules: tuple[NodeRule, ...]
    tree_rules: tuple[tuple[Rule, Callable[[], Iterable[Flaw]]], ...]
    findings: tuple[Finding, ...]


def bind(rules: Sequence[Rule], tree: Tree) -> Bound:
    """Make the checks of rules ready for a tree. A rule whose options do not fit its check is a finding."""
    node_rules: list[NodeRule] = []
    tree_rules: list[tuple[Rule, Callable[[], Iterable[Flaw]]]] = []
    findings: list[Finding] = []
    for rule in rules:
        if rule.check in MAKERS:
            continue
        try:
            check = _check_of(rule)
            if isinstance(check, NodeCheck):
                node_rules.append(_node_rule(rule, check, tree))
            elif isinstance(check, TreeCheck):
                tree_rules.append((rule, check.prepare(rule, tree)))
        except (BadOption, BadPattern) as error:
            fix = error.fix if isinstance(error, BadOption) else ""
            findings.append(Finding("L010", "error", str(error), rule.file, rule.line, 1, rule.id, fix=fix))
    return Bound(tuple(node_rules), tuple(tree_rules), tuple(findings))


def refuse_unusable(rules: Sequence[Rule], catalogue: Catalogue) -> None:
    """Raises InputRefused if any rule names a check that does not exist, or options that are not its own."""
    findings = bind(rules, Tree(catalogue)).findings
    if findings:
        raise InputRefused("The rules cannot be used.", findings)


def _check_of(rule: Rule) -> Check:
    check = CHECKS.get(rule.check)
    if check is None:
        raise BadOption(f"Rule {rule.id} names the unknown check {rule.check!r}.", did_you_mean(rule.check, CHECKS))
    check_options(rule, check)
    return check


@cache
def _matcher(glob: str) -> Callable[[str], object]:
    return re.compile(translate(glob)).match


def _node_rule(rule: Rule, check: NodeCheck, tree: Tree) -> NodeRule:
    needs = check.needs[1:] if check.needs.startswith("=") else str(rule.options.get(check.needs, ""))
    glob = _matcher(rule.nodes.path) if rule.nodes.path else None
    return NodeRule(rule, check.prepare(rule, tree), needs.partition(".")[0], glob, check.of_overlays)


def _node_findings(rules: Sequence[NodeRule], tree: Tree, among: Iterable[Definition]) -> Iterator[Found]:
    usable = rules if tree.overlays else [rule for rule in rules if not rule.of_overlays]
    choices: dict[tuple[str, str], _Choice] = {}
    ended: set[str] = set()
    for definition in among:
        key = (definition.type, category_of(definition.path) or "")
        if key not in choices:
            choices[key] = _choice([rule for rule in usable if _concerns(rule.rule, *key)])
        for node_rule in _for_values(choices[key], definition.values):
            if not node_rule.concerns(definition):
                continue
            flaws = node_rule.test(definition)
            if not node_rule.rule.trusted:
                yield from _until_slow(node_rule.rule, flaws, ended)
                continue
            for flaw in flaws:
                yield _finding(node_rule.rule, flaw), flaw.repair


def _until_slow(rule: Rule, flaws: Iterable[Flaw], ended: set[str]) -> Iterator[Found]:
    """What a rule of others finds in one node; nothing more after the first match that took too long."""
    if rule.id not in ended:
        for found in _guarded(rule, flaws):
            if found[0].rule == "L011":
                ended.add(rule.id)
            yield found


def _choice(rules: Sequence[NodeRule]) -> _Choice:
    by_need: dict[str, list[NodeRule]] = {}
    for rule in rules:
        by_need.setdefault(rule.needs, []).append(rule)
    return _Choice(by_need.pop("", []), by_need)


def _for_values(choice: _Choice, values: Mapping[str, Any]) -> Iterator[NodeRule]:
    yield from choice.always
    for name, value in values.items():
        if name in choice.by_need and value is not None:
            yield from choice.by_need[name]


def _concerns(rule: Rule, node_type: str, category: str) -> bool:
    nodes = rule.nodes
    return (not nodes.types or node_type in nodes.types) and (not nodes.interfaces or category in nodes.interfaces)


def _guarded(rule: Rule, flaws: Iterable[Flaw]) -> Iterator[Found]:
    """The flaws as findings; a pattern that takes too long is a finding about its rule."""
    try:
        for flaw in flaws:
            yield _finding(rule, flaw), flaw.repair
    except SlowPattern as error:
        message = f"Pattern {error.pattern!r} of rule {rule.id} takes too long; the rule is not finished."
        fix = "Write it without nested repetition, such as (a+)+."
        yield Finding("L011", "error", message, rule.file, rule.line, 1, rule.id, fix=fix), None


def _finding(rule: Rule, flaw: Flaw) -> Finding:
    place, path = _place(flaw), flaw.subject.path
    facts = {"path": path, "name": path.rpartition(".")[2], **flaw.facts}
    message = filled(rule.message, facts) if rule.message else flaw.message
    fix = filled(rule.fix, facts) if rule.fix else flaw.fix
    return Finding(rule.id, rule.severity, message, place[0], place[1], place[2], path, fix=fix)


def _place(flaw: Flaw) -> tuple[Any, ...]:
    subject, attribute = flaw.subject, flaw.attribute
    if flaw.within:
        return subject.origin_within(attribute, flaw.within, at_key=flaw.at_name) or subject.origin(attribute)
    return _name_origin(subject, attribute) if flaw.at_name else subject.origin(attribute)


def _name_origin(subject: Any, attribute: str) -> tuple[Any, ...]:
    if isinstance(subject, Definition):
        written = (s for s in reversed(subject.statements) if attribute in s.values)
        statement = next(written, None)
        return statement.origin_of_key(attribute) if statement is not None else subject.origin()
    assert isinstance(subject, Statement)
    return subject.origin_of_key(attribute)


def filled(template: str, facts: Mapping[str, Any]) -> str:
    """A rule's own message with its facts. Plain names only: a template cannot reach into objects."""

    def fact(match: re.Match[str]) -> str:
        if match[1] not in facts:
            return match[0]
        value = facts[match[1]]
        return repr(value) if match[2] else str(value)

    return _FIELD.sub(fact, template)


def _composition(catalogue: Catalogue, tree: Tree, rules: Sequence[Rule]) -> Iterator[Found]:
    """What composing found. A branch that is an instance is defined by its instances, so nobody has to write it."""
    active = {rule.id for rule in rules}
    severities = {rule.id: rule.severity for rule in rules if rule.check == "composition"}
    replaced = "O101" in active
    for finding in catalogue.findings:
        if finding.rule == "V020" and tree.is_instance(finding.path):
            continue
        if replaced and finding.rule == "V001" and _is_overlay_change(finding.path, tree):
            continue
        severity = severities.get(finding.rule, finding.severity)
        yield finding if severity == finding.severity else finding._replace(severity=severity), None


def _is_overlay_change(path: str, tree: Tree) -> bool:
    """Whether the node is unknown and an overlay changes it: rule O101 says so, and better."""
    definition = tree.definitions.get(path)
    return definition is not None and bool(definition.statements[0].file.overlay) and "type" not in definition.values
