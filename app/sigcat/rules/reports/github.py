"""Findings as workflow commands of GitHub Actions: annotations in the changed lines of a pull request."""

from collections.abc import Mapping, Sequence

from sigcat.findings import Finding
from sigcat.rules.record import Rule
from sigcat.rules.reports.fingerprint import relative
from sigcat.rules.reports.text import count

_LEVELS = {"error": "error", "warning": "warning", "info": "notice"}


def report(findings: Sequence[Finding], _sources: Mapping[str, str], _rules: Sequence[Rule]) -> str:
    """A command for each finding, and a count that is not a command."""
    return "".join(_command(finding) for finding in findings) + count(findings) + "\n"


def _command(finding: Finding) -> str:
    properties = {
        "file": finding.file and relative(finding.file),
        "line": finding.line,
        "col": finding.column,
        "title": f"sigcat {finding.rule}",
    }
    given = ",".join(f"{name}={_property(str(value))}" for name, value in properties.items() if value)
    advice = f" {finding.fix}" if finding.fix else ""
    return f"::{_LEVELS[finding.severity]} {given}::{_data(finding.message + advice)}\n"


def _data(text: str) -> str:
    return text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def _property(text: str) -> str:
    return _data(text).replace(":", "%3A").replace(",", "%2C")
