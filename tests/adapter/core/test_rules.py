"""Every rule about adapters does what its own examples say."""

import pytest

from sigcat.adapter.core.planned_core import derive
from sigcat.data import INTERFACE_RULES
from sigcat.errors import InputRefused
from sigcat.function.function_file import checked_file
from sigcat.rules.compiled import compiled_rules
from tests.function.shipped import interfaces

OWN = [rule for rule in compiled_rules(INTERFACE_RULES) if rule.check == "adapter"]
GOOD = [pytest.param(rule, e, id=f"{rule.id}-{i}") for rule in OWN for i, e in enumerate(rule.good, 1)]
BAD = [pytest.param(rule, e, id=f"{rule.id}-{i}") for rule in OWN for i, e in enumerate(rule.bad, 1)]


def findings_of(example):
    checked = checked_file(example.encode(), "function.yaml", interfaces())
    assert checked.sound is not None, checked.findings
    try:
        return derive(checked.sound).findings
    except InputRefused as refused:
        return refused.findings


def test_there_are_rules():
    assert len(OWN) >= 5
    with_examples = [rule for rule in OWN if rule.good]
    assert len(with_examples) >= 4
    assert len(GOOD) >= len(with_examples)
    assert len(BAD) >= len(with_examples)


@pytest.mark.parametrize(("rule", "example"), GOOD)
def test_a_good_example_has_no_finding(rule, example):
    assert findings_of(example) == ()


@pytest.mark.parametrize(("rule", "example"), BAD)
def test_a_bad_example_has_a_finding_of_its_rule(rule, example):
    (finding,) = findings_of(example)
    assert (finding.rule, finding.severity) == (rule.id, rule.severity)
    assert finding.line


@pytest.mark.parametrize(("size", "what"), [(0, "has no elements"), (65_536, "has more than 65,535 elements")])
def test_an_array_has_as_many_elements_as_a_control_unit_can_hold(size, what):
    (example,) = next(rule for rule in OWN if rule.name == "value-not-carried").bad
    own = f"  data:\n    Vehicle.List: {{datatype: 'float[]', arraysize: {size}, description: A list.}}\n"
    changed = example.replace("Vehicle.VehicleIdentification.VIN", "Vehicle.List").replace(
        "define:\n", f"define:\n{own}"
    )
    (finding,) = [finding for finding in findings_of(changed) if finding.severity == "error"]
    assert (finding.rule, what in finding.message) == ("G002", True)
