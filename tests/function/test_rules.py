"""Every rule about function files does what its own examples say."""

import pytest

from sigcat.data import INTERFACE_RULES
from sigcat.function.function_file import check_function
from sigcat.function.sets.check_set import check_functions
from sigcat.rules.record import load_rule_files
from tests.function.shipped import interfaces

RULES = load_rule_files([INTERFACE_RULES / "function.yaml"], trusted=True)
GOOD = [pytest.param(rule, text, id=f"{rule.id}-{i}") for rule in RULES for i, text in enumerate(rule.good, 1)]
BAD = [pytest.param(rule, text, id=f"{rule.id}-{i}") for rule in RULES for i, text in enumerate(rule.bad, 1)]


def findings_of(example):
    """An example is one file, or a whole set."""
    if isinstance(example, str):
        return check_function(example.encode(), "function", interfaces())
    return check_functions([(text.encode(), name) for name, text in example["files"].items()], interfaces())


@pytest.mark.parametrize(("rule", "text"), GOOD)
def test_a_good_example_has_no_finding_of_its_rule(rule, text):
    findings = findings_of(text)
    assert [finding for finding in findings if finding.rule == rule.id] == []


@pytest.mark.parametrize(("rule", "text"), BAD)
def test_a_bad_example_has_a_finding_of_its_rule_with_a_place(rule, text):
    findings = findings_of(text)
    own = [finding for finding in findings if finding.rule == rule.id]
    assert own, [(finding.rule, finding.message) for finding in findings]
    assert all(finding.message and finding.line and finding.column for finding in own)
