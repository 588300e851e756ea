"""The report of a migration in Markdown, for a pull request."""

from collections.abc import Iterator, Sequence

from sigcat.findings import Finding
from sigcat.migration.changed_text import Migrated
from sigcat.terminal_text import printable


def markdown(files: Sequence[Migrated], old: str, new: str) -> str:
    """Return the changes of each file, and the findings that remain."""
    return "\n".join(_lines(files, old, new)) + "\n"


def summary(files: Sequence[Migrated]) -> str:
    """Return the number of changes and of findings on one line."""
    changed = [file for file in files if file.is_changed]
    changes = sum(len(file.changes) for file in changed)
    findings = sum(len(file.findings) for file in files)
    counted = f"{_count(changes, 'change')} in {_count(len(changed), 'file')}"
    return f"{counted}, {_count(findings, 'finding')}" if changes or findings else "Nothing to migrate."


def _lines(files: Sequence[Migrated], old: str, new: str) -> Iterator[str]:
    yield f"# Migration from {_code(old)} to {_code(new)}"
    yield ""
    yield f"{summary(files).rstrip('.')}."
    findings = [finding for file in files for finding in file.findings]
    if findings:
        yield from ("", "## To decide", "")
        yield from (f"- {_finding(finding)}" for finding in findings)
    for file in files:
        if file.changes:
            yield from ("", f"## {_code(file.file)}", "")
            yield from (f"- line {line}: {printable(note)}" for line, note in file.changes)


def _finding(finding: Finding) -> str:
    place = f"{finding.file}:{finding.line}"
    text = f"{finding.message} {finding.fix}".strip()
    return f"{_code(place)} {finding.severity} {finding.rule}: {_code(text)}"


def _code(text: str) -> str:
    content = printable(" ".join(text.split()))
    fence = "``" if "`" in content else "`"
    pad = " " if "`" in content else ""
    return f"{fence}{pad}{content}{pad}{fence}"


def _count(number: int, noun: str) -> str:
    return f"{number} {noun}{'' if number == 1 else 's'}"
