"""The engine: rules and a catalogue in, findings out. Knows nothing of files, formats or the command line."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from sigcat import codes
from sigcat.catalogue.composing.build_tree import fix_of_undefined
from sigcat.catalogue.composing.instance_names import levels_of_instances
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.catalogue.model.definition import Definition
from sigcat.catalogue.model.interfaces import category_of
from sigcat.catalogue.reading.statement import Origin, Statement
from sigcat.findings import Finding
from sigcat.names import parent_path
from sigcat.rules.checks.kind import NodeTest
from sigcat.rules.near_paths import with_another_branch
from sigcat.rules.patterns import SlowPattern
from sigcat.rules.problem import Problem, Repair, Subject
from sigcat.rules.record import Rule
from sigcat.rules.rule_set import NodeRule, RuleSet, Selection
from sigcat.rules.templates import filled
from sigcat.rules.tree import Tree

if TYPE_CHECKING:
    from sigcat.catalogue.network.can_database import CanDatabase

Found = tuple[Finding, Repair | None]
"""A finding, and the change of bytes that repairs it, if there is one."""


def found_in(
    catalogue: Catalogue,
    rules: RuleSet,
    among: Iterable[Definition] | None = None,
    attributes: Iterable[str] = (),
    can: "CanDatabase | None" = None,
) -> Iterator[Found]:
    """Findings with their repairs. `among` are the definitions that are checked; without it, all are.

    There may be findings in the files of others too; a caller who checks only some leaves these out. `attributes` are names of extended attributes that count as known, beside those of the rules' tables; `can` is the CAN database that mappings are checked against.
    """
    tree = Tree(catalogue, rules.attributes.union(attributes), among, can)
    yield from _composition(catalogue, tree, rules)
    for finding in rules.findings:
        yield finding, None
    yield from _node_findings(rules, tree)
    for rule, check in rules.tree_rules:
        yield from _guarded(rule, check.prepare(rule, tree)())


def lint_lines(content: str, name: str, rules: RuleSet) -> Iterator[Found]:
    """Findings of the rules that look at the text of a file."""
    for rule, test in rules.line_rules:
        for line, column, message, fix, repair in test(content):
            yield Finding(rule.id, rule.severity, message, name, line, column, fix=fix), repair


def _node_findings(rules: RuleSet, tree: Tree) -> Iterator[Found]:
    has_overlays = bool(tree.overlays)
    tests: dict[str, NodeTest] = {}
    ended: set[str] = set()
    for written in tree.judged:
        definition = tree.resolved(written)
        selection = rules.select(definition.type, category_of(definition.path) or "", has_overlays=has_overlays)
        is_deleted = _is_deleted_in_vain(definition)
        for node_rule in _for_values(selection, definition.values):
            if not (node_rule.is_for_all or node_rule.concerns(definition)):
                continue
            if is_deleted and not node_rule.check.of_overlays:
                continue
            rule = node_rule.rule
            test = tests.get(rule.id)
            if test is None:
                test = tests[rule.id] = node_rule.check.prepare(rule, tree)
            problems = test(definition)
            if definition is not written:
                problems = _brought_by(written, problems)
            if not rule.trusted:
                yield from _until_slow(rule, problems, ended)
                continue
            for problem in problems:
                yield _finding(rule, problem), problem.repair


def _brought_by(written: Definition, problems: Iterable[Problem]) -> Iterator[Problem]:
    """Return the problems of one instance that come from values written for it: the definition has its others itself."""
    for problem in problems:
        if problem.subject in written.statements or any(problem.attribute in s.values for s in written.statements):
            yield problem


def _until_slow(rule: Rule, problems: Iterable[Problem], ended: set[str]) -> Iterator[Found]:
    """Return the findings of a company's rule in one node; nothing after the first match that took too long."""
    if rule.id not in ended:
        for found in _guarded(rule, problems):
            if found[0].rule == codes.RULE_TOO_SLOW.id:
                ended.add(rule.id)
            yield found


def _for_values(selection: Selection, values: Mapping[str, Any]) -> Iterator[NodeRule]:
    yield from selection.always
    for name, value in values.items():
        if name in selection.by_need and value is not None:
            yield from (each for each in selection.by_need[name] if _is_first(name, each.needs, values))


def _is_first(name: str, needs: Sequence[str], values: Mapping[str, Any]) -> bool:
    """Whether an attribute is the first one there of those that a rule needs: it checks a node once."""
    return len(needs) == 1 or next(each for each in needs if values.get(each) is not None) == name


def _guarded(rule: Rule, problems: Iterable[Problem]) -> Iterator[Found]:
    """The problems as findings; a pattern that takes too long is a finding about its rule."""
    try:
        for problem in problems:
            yield _finding(rule, problem), problem.repair
    except SlowPattern as error:
        message = f"Pattern {error.pattern!r} of rule {rule.id} takes too long; the rule was stopped."
        fix = "Write it without nested repetition such as (a+)+."
        yield codes.RULE_TOO_SLOW.finding(message, rule.file, rule.line, 1, rule.id, fix=fix), None


def _finding(rule: Rule, problem: Problem) -> Finding:
    origin, path = _origin(problem), problem.subject.path
    facts = {"path": path, "name": path.rpartition(".")[2], **problem.facts}
    message = filled(rule.message, facts) if rule.message else problem.message
    fix = filled(rule.fix, facts) if rule.fix else problem.fix
    return Finding(rule.id, rule.severity, message, origin.file, origin.line, origin.column, path, fix=fix)


def _origin(problem: Problem) -> Origin:
    subject, attribute = problem.subject, problem.attribute
    if problem.within:
        return subject.origin_within(attribute, problem.within, at_key=problem.at_name) or subject.origin(attribute)
    return _name_origin(subject, attribute) if problem.at_name else subject.origin(attribute)


def _name_origin(subject: Subject, attribute: str) -> Origin:
    if isinstance(subject, Definition):
        written = (s for s in reversed(subject.statements) if attribute in s.values)
        statement = next(written, None)
        return statement.origin_of_key(attribute) if statement is not None else subject.origin()
    assert isinstance(subject, Statement)
    return subject.origin_of_key(attribute)


def _composition(catalogue: Catalogue, tree: Tree, rules: RuleSet) -> Iterator[Found]:
    """Return the findings of composing, without those that follow from a reported one."""
    changes_are_reported = any(rule.check == "overlay-unknown-node" for rule in rules.rules)
    for finding in catalogue.findings:
        if finding.rule == codes.BRANCH_UNDEFINED.id and _need_not_be_written(
            finding.path, tree, changes_are_reported=changes_are_reported
        ):
            continue
        definition = tree.definitions.get(finding.path)
        if definition is not None and _is_deleted_in_vain(definition):
            continue
        if (
            changes_are_reported
            and finding.rule == codes.TYPE_MISSING_OR_UNKNOWN.id
            and _is_changed_in_vain(definition)
        ):
            continue
        if finding.rule == codes.BRANCH_UNDEFINED.id:
            if _is_below_another_instance(finding.path, tree):
                continue
            finding = _with_instances_proposed(finding, tree)  # noqa: PLW2901
        severity = rules.of_composition.get(finding.rule, finding.severity)
        yield finding if severity == finding.severity else finding._replace(severity=severity), None


def _with_instances_proposed(finding: Finding, tree: Tree) -> Finding:
    """A finding of a branch that is not defined, with the instances that were meant where its place is for these."""
    below = next((path for path in tree.definitions if path.startswith(f"{finding.path}.")), "")
    above = parent_path(finding.path)
    proposal = with_another_branch(below, tree) if below and tree.may_hold_instances(above) else ""
    if not proposal and (names := _instances_of(above, tree)):
        more = f" and {len(names) - _NAMED:,} more" if len(names) > _NAMED else ""
        proposal = f"The instances of {above!r} are {', '.join(names[:_NAMED])}{more}."
    return finding._replace(fix=fix_of_undefined(finding.path, proposal)) if proposal else finding


_NAMED = 8
"""Instances that a finding names."""


def _is_below_another_instance(branch: str, tree: Tree) -> bool:
    """Whether a branch is below one that instances have no name for: a finding about that one is enough."""
    above = parent_path(branch)
    return above not in tree.expanded and bool(_instances_of(parent_path(above), tree))


def _instances_of(path: str, tree: Tree) -> list[str]:
    definition = tree.definitions.get(path)
    return sorted(next(levels_of_instances(definition.values), ())) if definition is not None else []


def _need_not_be_written(branch: str, tree: Tree, *, changes_are_reported: bool) -> bool:
    """Whether a branch is an instance, which `instances` defines, or has nothing below it but what was reported already."""
    if tree.is_instance(branch):
        return True
    below = [definition for path, definition in tree.definitions.items() if path.startswith(f"{branch}.")]
    is_told = all(_is_deleted_in_vain(each) or (changes_are_reported and _is_changed_in_vain(each)) for each in below)
    return bool(below) and is_told


def _is_deleted_in_vain(definition: Definition) -> bool:
    """Whether an overlay deletes a node that is not there: the rule for that says all there is to say."""
    if not definition.values.get("delete"):
        return False
    first = definition.statements[0]
    return bool(first.values.get("delete")) and bool(first.file.overlay)


def _is_changed_in_vain(definition: Definition | None) -> bool:
    """Whether an overlay changes a node that is not there: the rule for that says so, and better."""
    return definition is not None and bool(definition.statements[0].file.overlay) and "type" not in definition.values
