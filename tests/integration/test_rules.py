"""Every rule about integrations and configurations does what its own examples say, and no code is without a rule."""

import ast
from collections import defaultdict
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from sigcat.catalogue.hosting.configuration import FILE_NAME, read_configuration
from sigcat.data import INTERFACE_RULES
from sigcat.errors import InputRefused
from sigcat.findings import SEVERITIES
from sigcat.function.document.severities import SEVERITIES as OF_FUNCTIONS
from sigcat.integration.autosar_adaptive import derive as adaptive
from sigcat.integration.autosar_adaptive.document import read_integration
from sigcat.integration.deployment import DEFAULT_DEPLOYMENT, read_deployment
from sigcat.integration.reading import read_functions
from sigcat.integration.ros2 import derive as ros2
from sigcat.integration.ros2.limits import SEVERITIES as OF_ROS2
from sigcat.rules.record import load_rules
from tests.function.shipped import interfaces

APP = Path(__file__).parents[2] / "app" / "sigcat"
RULES = load_rules(INTERFACE_RULES)
OWN = [rule for rule in RULES if rule.check in ("integration", "configuration")]
GRADED_OTHERWISE = {
    "V020": "composing goes on with a branch that it made, and warns; `sigcat lint` takes the severity of the record",
}
GOOD = [pytest.param(rule, e, id=f"{rule.id}-{i}") for rule in OWN for i, e in enumerate(rule.good, 1)]
BAD = [pytest.param(rule, e, id=f"{rule.id}-{i}") for rule in OWN for i, e in enumerate(rule.bad, 1)]


def findings_of(rule, example, folder):
    """An example is a function, or files with a deployment; Integration JSON; or a configuration with its files."""
    parts: Any = {"files": {"function": example}} if isinstance(example, str) else example
    if rule.check == "configuration":
        return findings_of_configuration(parts["files"], folder)
    if "document" in parts:
        return findings_of_document(parts["document"].encode())
    read, _ = read_functions([(text.encode(), name) for name, text in parts["files"].items()], interfaces)
    deployment = (
        read_deployment(parts["deployment"].encode(), "deployment.yaml")
        if "deployment" in parts
        else DEFAULT_DEPLOYMENT
    )
    derive = ros2.derive if rule.id.startswith("N") else adaptive.derive
    return derive(read, deployment).findings


def findings_of_document(data):
    try:
        read_integration(data, "integration.json")
    except InputRefused as refused:
        return refused.findings
    return ()


def findings_of_configuration(files, folder):
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    try:
        read_configuration(folder / FILE_NAME)
    except InputRefused as refused:
        return refused.findings
    return ()


@pytest.mark.parametrize(("rule", "example"), GOOD)
def test_a_good_example_has_no_finding_of_its_rule(rule, example, tmp_path):
    findings = findings_of(rule, example, tmp_path)
    assert [finding for finding in findings if finding.rule == rule.id] == []


@pytest.mark.parametrize(("rule", "example"), BAD)
def test_a_bad_example_has_a_finding_of_its_rule(rule, example, tmp_path):
    findings = findings_of(rule, example, tmp_path)
    own = [finding for finding in findings if finding.rule == rule.id]
    assert own, [(finding.rule, finding.message) for finding in findings]
    assert all(finding.message for finding in own)
    assert own[0].severity == rule.severity or is_milder(rule, own[0])


def is_milder(rule, finding):
    """Whether the code reports the rule with this severity where less is lost."""
    return finding.severity in emitted()[rule.id] and SEVERITIES.index(finding.severity) > SEVERITIES.index(
        rule.severity
    )


@cache
def emitted():
    """Severities with which the code of sigcat reports each rule; none where a call does not name it."""
    found: defaultdict[str, set[str]] = defaultdict(set)
    for file in APP.glob("**/*.py"):
        for node in ast.walk(ast.parse(file.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Constant) and isinstance(node.value, str) and is_code(node.value):
                found[node.value] |= set()
            if isinstance(node, ast.Call):
                codes, severities = named_in(node)
                for code in codes:
                    found[code] |= severities
    for table in (OF_FUNCTIONS, OF_ROS2):
        for code, severity in table.items():
            found[code].add(severity)
    return found


def named_in(call):
    """The codes among the arguments of a call, and the severities among those that follow."""
    values = [argument.value for argument in call.args if isinstance(argument, ast.Constant)]
    return [value for value in values if is_code(value)], {value for value in values if value in SEVERITIES}


def is_code(value):
    return isinstance(value, str) and len(value) == 4 and value[0].isupper() and value[1:].isdecimal()


def test_every_code_that_is_emitted_has_a_record():
    assert set(emitted()) <= {rule.id for rule in RULES}


@pytest.mark.parametrize("code", [code for code, severities in sorted(emitted().items()) if severities])
def test_a_record_has_the_gravest_severity_of_its_code(code):
    (rule,) = [rule for rule in RULES if rule.id == code]
    assert code in GRADED_OTHERWISE or rule.severity == min(emitted()[code], key=SEVERITIES.index)


def test_every_record_of_an_integration_and_of_a_configuration_is_emitted():
    assert {rule.id for rule in OWN} <= set(emitted())
