"""Every rule about traces does what its own examples say."""

import pytest

from sigcat.adapter.host.shapes import Number
from sigcat.data import INTERFACE_RULES
from sigcat.errors import InputRefused
from sigcat.rules.compiled import compiled_rules
from sigcat.runs.recording.trace_file import Known, moments, open_trace

OWN = [rule for rule in compiled_rules(INTERFACE_RULES) if rule.check == "simulation"]
GOOD = [pytest.param(rule, e, id=f"{rule.id}-{i}") for rule in OWN for i, e in enumerate(rule.good, 1)]
BAD = [pytest.param(rule, e, id=f"{rule.id}-{i}") for rule in OWN for i, e in enumerate(rule.bad, 1)]
KNOWN = Known({"Vehicle.Speed": Number("float")}, ("Vehicle.Mass",), inputs=(("Vehicle.Speed",),))


def findings_of(example, folder):
    file = folder / "trace.csv"
    file.write_text(example)
    try:
        trace = open_trace(file, KNOWN)
        list(moments(trace))
    except InputRefused as refused:
        return refused.findings
    return trace.findings


def test_there_are_rules():
    assert len(GOOD) == len(BAD) == 6


@pytest.mark.parametrize(("rule", "example"), GOOD)
def test_a_good_example_has_no_finding(rule, example, tmp_path):
    assert findings_of(example, tmp_path) == ()


@pytest.mark.parametrize(("rule", "example"), BAD)
def test_a_bad_example_has_a_finding_of_its_rule(rule, example, tmp_path):
    (finding, *_) = (each for each in findings_of(example, tmp_path) if each.rule == rule.id)
    assert (finding.rule, finding.severity) == (rule.id, rule.severity)
    assert finding.line
