"""Findings as JSON: `{"findings": [...], "counts": {...}}`, one object for each finding."""

import json
from collections import Counter
from collections.abc import Mapping, Sequence

from sigcat.findings import SEVERITIES, Finding
from sigcat.rules.record import Rule


def report(findings: Sequence[Finding], _sources: Mapping[str, str], _rules: Sequence[Rule]) -> str:
    """Every field of every finding, and how many there are of each severity."""
    counts = Counter(finding.severity for finding in findings)
    data = {
        "findings": [finding._asdict() for finding in findings],
        "counts": {severity: counts[severity] for severity in SEVERITIES},
    }
    return json.dumps(data, indent=2, ensure_ascii=False) + "\n"
