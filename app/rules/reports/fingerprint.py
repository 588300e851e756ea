"""Fingerprints: what a finding is called whatever line it stands on."""

import hashlib
from collections.abc import Iterable, Iterator

from app.findings import Finding


def fingerprinted(findings: Iterable[Finding]) -> Iterator[tuple[Finding, str]]:
    """Findings with a fingerprint of rule and node path (or file, if no node is concerned), each one unique."""
    seen: dict[str, int] = {}
    for finding in findings:
        key = f"{finding.rule}\0{finding.path or finding.file}"
        number = seen.get(key, 0)
        seen[key] = number + 1
        yield finding, hashlib.sha256(f"{key}\0{number}".encode("utf-8", "surrogatepass")).hexdigest()
