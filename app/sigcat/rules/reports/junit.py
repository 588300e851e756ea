"""Findings as a JUnit report: a suite for each file, a failed case for each finding."""

import re
from collections.abc import Mapping, Sequence
from html import escape
from itertools import groupby

from sigcat.findings import Finding
from sigcat.rules.record import Rule

_NOT_XML = re.compile(r"[^\t\n\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")


def report(findings: Sequence[Finding], _sources: Mapping[str, str], _rules: Sequence[Rule]) -> str:
    """XML. Notes are cases that pass; a run without findings has one case that passes."""
    suites = [_suite(file, list(group)) for file, group in groupby(findings, key=lambda finding: finding.file)]
    if not suites:
        suites = ['  <testsuite name="sigcat" tests="1" failures="0">\n    <testcase name="lint"/>\n  </testsuite>\n']
    failures = sum(finding.severity != "info" for finding in findings)
    head = f'<testsuites name="sigcat lint" tests="{max(len(findings), 1)}" failures="{failures}">\n'
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + head + "".join(suites) + "</testsuites>\n"


def _suite(file: str, findings: Sequence[Finding]) -> str:
    failures = sum(finding.severity != "info" for finding in findings)
    cases = "".join(map(_case, findings))
    return (
        f'  <testsuite name={_attribute(file)} tests="{len(findings)}" failures="{failures}">\n{cases}  </testsuite>\n'
    )


def _case(finding: Finding) -> str:
    name = f"{finding.rule} {finding.path or finding.file}:{finding.line}"
    head = f"    <testcase name={_attribute(name)} classname={_attribute(finding.file)}"
    advice = f" {finding.fix}" if finding.fix else ""
    if finding.severity == "info":
        return f"{head}>\n      <system-out>{_text(finding.message + advice)}</system-out>\n    </testcase>\n"
    position = f"{finding.file}:{finding.line}:{finding.column}"
    failure = f"<failure type={_attribute(finding.severity)} message={_attribute(finding.message)}>"
    return f"{head}>\n      {failure}{_text(f'{position}: {finding.message}{advice}')}</failure>\n    </testcase>\n"


def _attribute(text: str) -> str:
    return f'"{escape(_xml(text))}"'.replace("\n", "&#10;").replace("\t", "&#9;")


def _text(text: str) -> str:
    return escape(_xml(text), quote=False)


def _xml(text: str) -> str:
    """Characters that XML has no way to write, replaced."""
    return _NOT_XML.sub("\ufffd", text)
