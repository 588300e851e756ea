"""Findings as a Code Quality report of GitLab (a subset of the Code Climate format)."""

import json
from collections.abc import Mapping, Sequence

from sigcat.findings import Finding
from sigcat.rules.record import Rule
from sigcat.rules.reports.fingerprint import fingerprinted, relative

_SEVERITIES = {"error": "major", "warning": "minor", "info": "info"}


def report(findings: Sequence[Finding], _sources: Mapping[str, str], _rules: Sequence[Rule]) -> str:
    """A JSON list of issues; the same finding has the same fingerprint wherever its node moves to."""
    return json.dumps([_issue(f, fingerprint) for f, fingerprint in fingerprinted(findings)], indent=2) + "\n"


def _issue(finding: Finding, fingerprint: str) -> dict[str, object]:
    advice = f" {finding.fix}" if finding.fix else ""
    return {
        "description": finding.message + advice,
        "check_name": finding.rule,
        "fingerprint": fingerprint,
        "severity": _SEVERITIES[finding.severity],
        "location": {"path": relative(finding.file), "lines": {"begin": max(finding.line, 1)}},
    }
