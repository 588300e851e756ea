"""Severities of findings: those of the records, and those that a configuration sets for all files or for some."""

from collections.abc import Iterable, Iterator, Mapping
from fnmatch import fnmatchcase
from pathlib import Path, PurePath
from typing import Any, NamedTuple, Self

from sigcat.errors import UsageError
from sigcat.findings import SEVERITIES, Finding, Severity
from sigcat.names import did_you_mean
from sigcat.real_path import real_path
from sigcat.rules.linting.options import LintOptions, PerFile

OFF = "off"


class ConfiguredSeverities(NamedTuple):
    """Severities that a project sets, for findings of rules that composing reports in every command."""

    ignore: tuple[str, ...]
    selected: tuple[str, ...]
    """Codes of rules that are reported although `ignore` has the start of them."""
    severities: tuple[tuple[str, str], ...]
    per_file: tuple[tuple[str, tuple[tuple[str, str], ...]], ...]
    root: Path

    @classmethod
    def of(cls, options: LintOptions) -> Self:
        """Return those of a configuration, as values that another process can be sent."""
        per_file = tuple((entry.glob, tuple(entry.severities.items())) for entry in options.per_file)
        selected = (*options.select, *options.extend_select)
        return cls(options.ignore, selected, tuple(options.severities.items()), per_file, options.root)

    def graded(self, finding: Finding) -> Finding | None:
        """Return the finding with its configured severity; None if its rule is off."""
        if finding.rule.startswith(self.ignore) and finding.rule not in self.selected:
            return None
        graded = _graded_by(finding, dict(self.severities))
        per_file = (PerFile(glob, dict(severities)) for glob, severities in self.per_file)
        return graded and _graded_in_file(graded, per_file, self.root)


class Grading(NamedTuple):
    """Severities of the rules that run. A finding whose code has no record keeps its own."""

    severities: Mapping[str, Severity]
    codes: frozenset[str]
    """Codes of all rules, those that do not run among them."""
    options: LintOptions

    def graded(self, findings: Iterable[Finding]) -> Iterator[Finding]:
        """Findings of rules that run, with their severities; those of other rules are left out."""
        for finding in findings:
            severity = self.severities.get(finding.rule)
            if severity is None and finding.rule in self.codes:
                continue
            if severity is not None and severity != finding.severity:
                finding = finding._replace(severity=severity)  # noqa: PLW2901 — the finding as this lint grades it
            final = _graded_in_file(finding, self.options.per_file, self.options.root)
            if final is not None:
                yield final


def _graded_in_file(finding: Finding, per_file: Iterable[PerFile], root: Path) -> Finding | None:
    """The finding with the severity that its file gives its rule; None where the rule is off."""
    for entry in per_file:
        if matches(finding.file, entry.glob, root):
            graded = _graded_by(finding, entry.severities)
            if graded is None:
                return None
            finding = graded
    return finding


def _graded_by(finding: Finding, severities: Mapping[str, Any]) -> Finding | None:
    """The finding with the severity that a table gives its rule; None if the rule is off."""
    severity = most_specific(finding.rule, severities)
    if severity == OFF:
        return None
    return finding if severity is None else finding._replace(severity=as_severity(severity))


def matches(file: str, glob: str, root: Path) -> bool:
    """Whether a file matches a glob relative to `root`; a folder includes all below it."""
    path = Path(file)
    try:
        name = real_path(path).relative_to(real_path(root)).as_posix()
    except ValueError:
        name = PurePath(file).as_posix()
    plain = glob.rstrip("/")
    return fnmatchcase(name, plain) or fnmatchcase(name, f"{plain}/*") or PurePath(name).match(plain)


def most_specific(code: str, severities: Mapping[str, Any]) -> str | None:
    """The severity of the longest key that `code` starts with."""
    keys = [key for key in severities if code.startswith(key)]
    return str(severities[max(keys, key=len)]) if keys else None


def as_severity(text: str) -> Severity:
    """A severity from a configuration. Raises UsageError."""
    for severity in SEVERITIES:
        if severity == text:
            return severity
    hint = did_you_mean(text, (*SEVERITIES, OFF))
    raise UsageError(f"A severity must be {', '.join(SEVERITIES)} or {OFF}, not {text!r}. {hint}".strip())
