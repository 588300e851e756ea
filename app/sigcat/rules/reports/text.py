"""Findings for people: position, rule, message, and the line with a caret below it."""

import re
from collections import Counter
from collections.abc import Mapping, Sequence

from sigcat.findings import SEVERITIES, Finding
from sigcat.rules.record import Rule
from sigcat.terminal_text import printable
from sigcat.text_lines import lines_of

_WORD = r"[\w.\[\]/%-]+"
_MOST = 160
"""Characters of a line that are shown."""
_COLOURS = {"error": "31", "warning": "33", "info": "36", "bold": "1", "dim": "2"}


def report(
    findings: Sequence[Finding], sources: Mapping[str, str], _rules: Sequence[Rule], *, colour: bool = False
) -> str:
    """Each finding with its line, and a count at the end."""
    lines: dict[str, list[str]] = {}
    parts = []
    for finding in findings:
        if finding.file not in lines:
            lines[finding.file] = lines_of(sources.get(finding.file, ""))
        parts.append(_finding(finding, lines[finding.file], colour))
    return "".join(parts) + count(findings) + "\n"


def count(findings: Sequence[Finding]) -> str:
    """`Found 2 errors and 1 warning in 1 file.`"""
    if not findings:
        return "No findings."
    counts = Counter(finding.severity for finding in findings)
    words = {"error": "error", "warning": "warning", "info": "note"}
    counted = [_plural(counts[severity], words[severity]) for severity in SEVERITIES if counts[severity]]
    files = len({finding.file for finding in findings})
    listed = " and ".join(part for part in (", ".join(counted[:-1]), counted[-1]) if part)
    return f"Found {listed} in {_plural(files, 'file')}."


def _plural(number: int, word: str) -> str:
    return f"{number:,} {word}{'' if number == 1 else 's'}"


def _finding(finding: Finding, lines: list[str], colour: bool) -> str:
    position = ":".join(
        str(part) for part in (printable(finding.file), finding.line or "", finding.column or "") if part
    )
    severity = _painted(finding.severity, finding.severity, colour)
    rule = _painted(finding.rule, "bold", colour)
    advice = f" {finding.fix}" if finding.fix else ""
    head = f"{position}: {severity} {rule} {printable(finding.message + advice)}\n".removeprefix(": ")
    return head + excerpt(finding, lines, colour=colour)


def excerpt(finding: Finding, lines: Sequence[str], *, colour: bool = False) -> str:
    """Return the line of a finding with a caret below the word; nothing if its file has no such line."""
    if not 0 < finding.line <= len(lines):
        return ""
    line = lines[finding.line - 1]
    start = max(finding.column - 1, 0)
    left = max(0, start - _MOST // 2) if len(line) > _MOST else 0
    shown = printable(line[left : left + _MOST].replace("\t", " "))
    token = re.compile(_WORD).match(line, start)
    width = min(max(len(token[0]) if token else 1, 1), _MOST - (start - left))
    gutter = f"{finding.line:>5} | "
    caret = " " * len(gutter) + " " * (start - left) + _painted("^" * width, finding.severity, colour)
    return f"{_painted(gutter, 'dim', colour)}{shown}\n{caret}\n"


def _painted(text: str, style: str, colour: bool) -> str:
    return f"\x1b[{_COLOURS[style]}m{text}\x1b[0m" if colour else text
