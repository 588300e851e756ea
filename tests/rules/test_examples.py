"""Every rule does what its own examples say, and every code that sigcat emits has a rule."""

from pathlib import Path

import pytest

from sigcat.catalogue.model.vocabulary import read_vocabulary
from sigcat.data import INTERFACE_RULES, VSPEC
from sigcat.errors import InputRefused
from sigcat.rules import engine, templates
from sigcat.rules.checks import CHECKS
from sigcat.rules.compiled import compiled_rules
from sigcat.rules.linting.examples import findings_of_example
from sigcat.rules.linting.lint import lint_paths
from sigcat.rules.linting.options import LintOptions
from sigcat.rules.linting.selection import rules_for
from sigcat.rules.record_faults import MAKERS
from sigcat.rules.rule_set import RuleSet
from sigcat.rules.templates import OF_EVERY_CHECK, placeholders

RULES = compiled_rules(INTERFACE_RULES)
EVERY_RULE = RuleSet(RULES)
UNITS = read_vocabulary([VSPEC / "units.yaml"], [VSPEC / "quantities.yaml"])
ELSEWHERE = ("adapter", "configuration", "export", "function", "gateway", "import", "integration", "simulation")
"""Generators whose examples are not trees: tests/function and tests/integration run them."""
TREES = [rule for rule in RULES if rule.check not in ELSEWHERE]
GOOD = [pytest.param(r, e, id=f"{r.id}-{i}") for r in TREES for i, e in enumerate(r.good, 1)]
BAD = [pytest.param(r, e, id=f"{r.id}-{i}") for r in TREES for i, e in enumerate(r.bad, 1)]


@pytest.mark.parametrize(("rule", "example"), GOOD)
def test_a_good_example_has_no_finding_of_its_rule(rule, example, tmp_path):
    findings = findings_of_example(example, EVERY_RULE, UNITS, tmp_path)
    assert [f for f in findings if f.rule == rule.id] == []


@pytest.mark.parametrize(("rule", "example"), BAD)
def test_a_bad_example_has_a_finding_of_its_rule(rule, example, tmp_path):
    findings = findings_of_example(example, EVERY_RULE, UNITS, tmp_path)
    own = [f for f in findings if f.rule == rule.id]
    assert own, f"only {[f.rule for f in findings]}"
    assert all(f.message and f.file for f in own)


def test_a_rule_names_a_check_and_has_examples():
    texts = {file: Path(file).read_text(encoding="utf-8") for file in {rule.file for rule in RULES}}
    for rule in RULES:
        assert rule.check in CHECKS or rule.check in MAKERS, rule.id
        text = texts[rule.file].split(f"\n{rule.id}:\n")[1].split("\n\n")[0]
        assert (rule.good and rule.bad) or "example: false" in text, rule.id
        assert rule.title.endswith("."), rule.id
        assert rule.why.endswith("."), rule.id


def test_names_of_rules_are_unique():
    names = [rule.name for rule in RULES]
    assert len(set(names)) == len(names)


def test_the_checks_of_shipped_rules_take_their_options():
    assert RuleSet(rule._replace(trusted=False) for rule in RULES).findings == ()


OWN_RULE = """\
OWN001:
  name: owner-missing
  title: Each signal has an owner.
  severity: error
  why: Questions need a team.
  check: required
  nodes: {types: [signals]}
  options: {attributes: [owner]}
  source: Conventions
  good: |
    Vehicle.A: {type: sensor, datatype: float, unit: km/h, owner: Team, description: A.}
  bad: |
    Vehicle.A: {type: sensor, datatype: float, unit: km/h, description: A.}
"""


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("", "", ""),
        ("owner: Team, ", "", "Rule OWN001 must not report its good example 1, and does: "),
        (
            "km/h, owner: Team",
            "km/h, owner: [",
            "Rule OWN001 must not report its good example 1, and does: Not valid YAML",
        ),
        (
            "km/h, description",
            "km/h, owner: Team, description",
            "Rule OWN001 must report its bad example 1, and does not.",
        ),
    ],
    ids=("as it says", "good", "unreadable", "bad"),
)
def test_examples_of_own_rules_are_run(old, new, message, tmp_path):
    file = tmp_path / "rules.yaml"
    file.write_text(OWN_RULE.replace(old, new) if old else OWN_RULE)
    found = [finding for finding in lint_paths([file]).findings if finding.rule == "L013"]
    assert len(found) == bool(message)
    assert all(finding.message.startswith(message) and finding.line == 1 for finding in found)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("OWN001", "V101", "sigcat has a rule with the code V101 already: "),
        ("owner-missing", "name-not-camel-case", "sigcat has a rule with the name 'name-not-camel-case' already: "),
    ],
    ids=("code", "name"),
)
def test_a_code_or_name_of_a_shipped_rule_is_refused(old, new, message, tmp_path):
    """The rule would take the place of the shipped one, whose findings would be gone."""
    file = tmp_path / "rules.yaml"
    file.write_text(OWN_RULE.replace(old, new))
    (finding,) = lint_paths([file]).findings
    assert (finding.rule, finding.line) == ("L010", 1)
    assert finding.message.startswith(message)
    with pytest.raises(InputRefused) as refused:
        rules_for(LintOptions(rule_files=(file,)))
    assert [each.message for each in refused.value.findings] == [finding.message]


@pytest.mark.parametrize(
    ("example", "message"),
    [
        ("5", "`good` must be a text or a list of texts, not 5."),
        ("[Vehicle.A, [a]]", "`good` must be a text or a list of texts, not "),
        ("{bas: x}", "Unknown field 'bas' in `good`."),
        ("{base: 5}", "`base` in `good` must be a text, not 5."),
        ("{overlays: x}", "`overlays` in `good` must be a list of texts, not 'x'."),
        ("{files: {}}", "`files` in `good` must be texts by file name, without folders, not "),
        ("{files: {../a.vspec: x}}", "`files` in `good` must be texts by file name, without folders, not "),
        ("{files: {..: x}}", "`files` in `good` must be texts by file name, without folders, not "),
        ("{files: {a.vspec: 5}}", "`files` in `good` must be texts by file name, without folders, not "),
        ("{1: x}", "Unknown field 1 in `good`."),
    ],
)
def test_an_example_of_another_form_is_refused_at_its_field(example, message, tmp_path):
    file = tmp_path / "rules.yaml"
    file.write_text(OWN_RULE.split("  good:", maxsplit=1)[0] + f"  good: {example}\n")
    (finding,) = lint_paths([file]).findings
    assert (finding.rule, finding.line) == ("L010", 10)
    assert finding.message.startswith(message)
    assert not (tmp_path.parent / "a.vspec").exists()


def test_placeholders_of_checks_are_those_that_their_problems_fill(monkeypatch, tmp_path):
    facts: dict[str, set[str]] = {}
    make = engine._finding

    def finding(rule, problem):
        facts.setdefault(rule.check, set()).update(problem.facts)
        return make(rule, problem)

    monkeypatch.setattr(engine, "_finding", finding)
    for number, rule in enumerate(TREES):
        for at, example in enumerate(rule.bad):
            folder = tmp_path / f"{number}-{at}"
            folder.mkdir()
            findings_of_example(example, EVERY_RULE, UNITS, folder)
    assert {check: sorted({*OF_EVERY_CHECK, *names}) for check, names in facts.items()} == {
        check: sorted(placeholders(check)) for check in facts
    }
    assert set(templates._OF_CHECKS) <= set(CHECKS)
