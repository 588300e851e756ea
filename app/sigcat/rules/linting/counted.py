"""Findings in short: what has one cause and many places in a file is one finding with their number."""

from collections import Counter
from collections.abc import Collection, Iterable, Iterator

from sigcat.findings import Finding


def counted(findings: Iterable[Finding], rules: Collection[str]) -> Iterator[Finding]:
    """The findings, those of `rules` that say the same of one file at the first place only, with their number.

    Reports are short so; suppressions, baselines and repairs are about each place.
    """
    findings = tuple(findings)
    counts = Counter(_said(finding) for finding in findings if finding.rule in rules)
    for finding in findings:
        count = counts.pop(_said(finding), 0) if finding.rule in rules else 1
        if count > 1:
            yield finding._replace(message=f"{finding.message.removesuffix('.')}, {count:,} times in this file.")
        elif count == 1:
            yield finding


def _said(finding: Finding) -> tuple[str, str, str]:
    return finding.rule, finding.file, finding.message
