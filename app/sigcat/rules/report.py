"""Findings as text for people, editors and build servers. Each format is a function of findings and sources."""

from collections.abc import Mapping, Sequence
from importlib import import_module

from sigcat.errors import UsageError
from sigcat.findings import Finding
from sigcat.names import did_you_mean
from sigcat.rules.record import Rule
from sigcat.rules.reports import text

Sources = Mapping[str, str]
"""Texts of the files by name, as far as they are known."""

FORMATS: Mapping[str, str] = {
    "text": "text",
    "json": "json_report",
    "github": "github",
    "gitlab": "gitlab",
    "sarif": "sarif",
    "junit": "junit",
}
"""Modules of `sigcat.rules.reports` by the name of their format; only the one that is asked for is loaded."""


def report(
    findings: Sequence[Finding],
    form: str = "text",
    sources: Sources | None = None,
    rules: Sequence[Rule] = (),
    *,
    colour: bool = False,
) -> str:
    """The findings in a format, ready to be written. Raises UsageError for a format that does not exist."""
    if form == "text":
        return _writable(text.report(findings, sources or {}, rules, colour=colour))
    if form not in FORMATS:
        hint = did_you_mean(form, FORMATS)
        raise UsageError(f"The format must be one of {', '.join(FORMATS)}, not {form!r}. {hint}".strip())
    made: str = import_module(f"sigcat.rules.reports.{FORMATS[form]}").report(findings, sources or {}, rules)
    return _writable(made)


def _writable(text: str) -> str:
    """The text with halves of characters replaced: names of files may hold them, and no encoding does."""
    return text if text.isascii() else text.encode("utf-8", "replace").decode("utf-8")


def sources_of(findings: Sequence[Finding]) -> dict[str, str]:
    """The texts of the files that findings point into, read from disk; a file that cannot be read is left out."""
    sources = {}
    for name in dict.fromkeys(finding.file for finding in findings if finding.line):
        try:
            with open(name, "rb") as file:  # noqa: PTH123 — the name as the finding has it
                sources[name] = file.read().decode("utf-8-sig", "replace")
        except (OSError, ValueError):
            continue
    return sources
