"""Findings as SARIF 2.1.0, within the limits of GitHub code scanning."""

import json
import os
from collections.abc import Mapping, Sequence
from typing import Any
from urllib.parse import quote

from sigcat import __version__
from sigcat.findings import Finding
from sigcat.rules.record import Rule
from sigcat.rules.reports.fingerprint import fingerprinted, relative

MOST_RESULTS = 25_000
"""GitHub refuses a run with more results; the most severe are kept."""

_LEVELS = {"error": "error", "warning": "warning", "info": "note"}
_RANKS = {"error": 0, "warning": 1, "info": 2}
_SCHEMA = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json"


def report(findings: Sequence[Finding], _sources: Mapping[str, str], rules: Sequence[Rule]) -> str:
    """One run; results are identified by rule and node path, so that they survive moves."""
    kept = list(fingerprinted(findings))
    if len(kept) > MOST_RESULTS:
        kept = sorted(kept, key=lambda pair: _RANKS[pair[0].severity])[:MOST_RESULTS]
    known = {rule.id: rule for rule in rules}
    codes = sorted({finding.rule for finding, _ in kept})
    driver = {
        "name": "sigcat",
        "semanticVersion": __version__,
        "rules": [_rule(code, known.get(code)) for code in codes],
    }
    indices = {code: index for index, code in enumerate(codes)}
    run = {
        "tool": {"driver": driver},
        "columnKind": "unicodeCodePoints",
        "results": [_result(finding, fingerprint, indices) for finding, fingerprint in kept],
    }
    return json.dumps({"$schema": _SCHEMA, "version": "2.1.0", "runs": [run]}, indent=2) + "\n"


def _rule(code: str, rule: Rule | None) -> dict[str, Any]:
    if rule is None:
        return {"id": code}
    return {
        "id": code,
        "name": "".join(part.capitalize() for part in rule.name.split("-")),
        "shortDescription": {"text": rule.title},
        "fullDescription": {"text": rule.why},
        "defaultConfiguration": {"level": _LEVELS[rule.severity]},
        "properties": {"category": rule.category, "tags": [rule.category]},
    }


def _result(finding: Finding, fingerprint: str, indices: Mapping[str, int]) -> dict[str, Any]:
    advice = f" {finding.fix}" if finding.fix else ""
    location: dict[str, Any] = {
        "physicalLocation": {"artifactLocation": {"uri": quote(os.fsencode(relative(finding.file)))}}
    }
    if finding.line:
        region = {"startLine": finding.line, "startColumn": max(finding.column, 1)}
        location["physicalLocation"]["region"] = region
    if finding.path:
        location["logicalLocations"] = [{"fullyQualifiedName": finding.path}]
    return {
        "ruleId": finding.rule,
        "ruleIndex": indices[finding.rule],
        "level": _LEVELS[finding.severity],
        "message": {"text": finding.message + advice},
        "locations": [location],
        "partialFingerprints": {"ruleAndPath/v1": fingerprint},
    }
