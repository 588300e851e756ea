"""Every rule about integrations and configurations does what its own examples say, and no code is without a rule."""

from typing import Any

import pytest

from sigcat import codes
from sigcat.data import INTERFACE_RULES
from sigcat.errors import InputRefused
from sigcat.function.sets.check_set import read_set
from sigcat.integration.autosar_adaptive.document import read_integration
from sigcat.integration.autosar_classic.document import read_integration as read_classic
from sigcat.integration.fmi.document import read_integration as read_fmi
from sigcat.limits import DEFAULT_LIMITS
from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT, read_deployment
from sigcat.platforms.platform import Options
from sigcat.platforms.table import PLATFORMS
from sigcat.project.project import FILE_NAME
from sigcat.project.read_project import read_project
from sigcat.project.vehicles import vehicle_findings
from sigcat.rules.compiled import compiled_rules
from tests.function.shipped import interfaces

RULES = compiled_rules(INTERFACE_RULES)
OWN = [rule for rule in RULES if rule.check in ("integration", "configuration")]
PLATFORM_OF = {"A": "autosar-adaptive", "K": "autosar-classic", "N": "ros2", "J": "fmi"}
"""Platforms by the first letter of their rules."""
GOOD = [pytest.param(rule, e, id=f"{rule.id}-{i}") for rule in OWN for i, e in enumerate(rule.good, 1)]
BAD = [pytest.param(rule, e, id=f"{rule.id}-{i}") for rule in OWN for i, e in enumerate(rule.bad, 1)]


def findings_of(rule, example, folder):
    """An example is a function, or files with a deployment; Integration JSON; or a configuration with its files."""
    parts: Any = {"files": {"function": example}} if isinstance(example, str) else example
    if rule.check == "configuration":
        return findings_of_configuration(parts["files"], folder)
    if "document" in parts:
        return findings_of_document(parts["document"].encode(), rule)
    members, _ = read_set([(text.encode(), name) for name, text in parts["files"].items()], interfaces())
    read = [member.resolved for member in members if member.resolved is not None]
    before = read_set([(parts["previous"].encode(), "previous.json")], interfaces())[0] if "previous" in parts else ()
    deployment = (
        read_deployment(parts["deployment"].encode(), "deployment.yaml")
        if "deployment" in parts
        else DEFAULT_DEPLOYMENT
    )
    platform = PLATFORMS[PLATFORM_OF[rule.id[0]]]
    settings = getattr(deployment, platform.section)
    integrated = platform.derive(read, deployment, settings)
    if platform.with_previous is not None and before:
        previous = platform.derive([each.resolved for each in before if each.resolved], deployment, settings)
        integrated = platform.with_previous(
            integrated, (previous.document, "previous.json"), deployment, DEFAULT_LIMITS
        )
    return (
        integrated.findings if rule.id != codes.NOT_WRITABLE_AS_ROS2.id else findings_of_packages(integrated.document)
    )


def findings_of_packages(document):
    try:
        PLATFORMS["ros2"].generators[0].generate(document, "ros2.json", DEFAULT_LIMITS, Options())
    except InputRefused as refused:
        return refused.findings
    return ()


def findings_of_document(data, rule):
    read = {"K": read_classic, "J": read_fmi}.get(rule.id[0], read_integration)
    try:
        read(data, "integration.json")
    except InputRefused as refused:
        return refused.findings
    return ()


def findings_of_configuration(files, folder):
    for name, text in files.items():
        (folder / name).write_text(text, encoding="utf-8")
    try:
        return tuple(vehicle_findings(read_project(folder / FILE_NAME)))
    except InputRefused as refused:
        return refused.findings


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
    assert own[0].severity == rule.severity
