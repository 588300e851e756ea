"""Every rule does what its own examples say, and every code that sigcat emits has a rule."""

from pathlib import Path

import pytest

from sigcat.catalogue.model.vocabulary import read_vocabulary
from sigcat.data import INTERFACE_RULES, VSPEC
from sigcat.rules.checks import CHECKS
from sigcat.rules.compiled import compiled_rules
from sigcat.rules.linting.examples import findings_of_example
from sigcat.rules.record import MAKERS
from sigcat.rules.rule_set import RuleSet

RULES = compiled_rules(INTERFACE_RULES)
EVERY_RULE = RuleSet(RULES)
UNITS = read_vocabulary([VSPEC / "units.yaml"], [VSPEC / "quantities.yaml"])
ELSEWHERE = ("adapter", "configuration", "export", "function", "gateway", "import", "integration", "simulation")
"""Makers whose examples are no trees: tests/function and tests/integration run them."""
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


@pytest.mark.parametrize("rule", RULES, ids=lambda rule: rule.id)
def test_a_rule_names_a_check_and_has_examples(rule):
    assert rule.check in CHECKS or rule.check in MAKERS
    text = Path(rule.file).read_text(encoding="utf-8").split(f"\n{rule.id}:\n")[1].split("\n\n")[0]
    assert (rule.good and rule.bad) or "example: false" in text
    assert rule.title.endswith(".")
    assert rule.why.endswith(".")


def test_names_of_rules_are_unique():
    names = [rule.name for rule in RULES]
    assert len(set(names)) == len(names)


def test_the_checks_of_shipped_rules_take_their_options():
    assert RuleSet(rule._replace(trusted=False) for rule in RULES).findings == ()
