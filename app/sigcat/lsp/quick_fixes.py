"""Turn the repairs of `sigcat lint --fix` into edits of one text."""

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat.findings import Finding
from sigcat.rules.linting.fixes import fixed_files
from sigcat.rules.linting.options import LintResult, identity_of


class QuickFix(NamedTuple):
    """A title, the findings that it settles, and the new text of the part from one offset to another."""

    title: str
    findings: tuple[Finding, ...]
    is_safe: bool
    start: int
    end: int
    text: str


def quick_fixes(result: LintResult, path: Path, text: str, chosen: Sequence[Finding]) -> Iterator[QuickFix]:
    """Return a fix for each of the chosen findings that has a repair."""
    for finding in chosen:
        repair = result.repairs.get(identity_of(finding))
        if repair is not None:
            title = finding.fix or f"Fix {finding.rule}"
            yield from _fix(result, path, text, [finding], title, is_safe=repair.safe)


def every_fix(result: LintResult, path: Path, text: str) -> Iterator[QuickFix]:
    """Return one fix that makes all safe repairs."""
    yield from _fix(result, path, text, result.findings, "Fix all that is safe (sigcat)", is_safe=True)


def _fix(
    result: LintResult, path: Path, text: str, findings: Iterable[Finding], title: str, *, is_safe: bool
) -> Iterator[QuickFix]:
    fixed = fixed_files(list(findings), result.repairs, {str(path): text}, unsafe=not is_safe)
    for each in fixed:
        start, end, new = _changed_part(each.before, each.after)
        yield QuickFix(title, each.settled, is_safe, start, end, new)


def _changed_part(before: str, after: str) -> tuple[int, int, str]:
    """Return the part that differs, and what replaces it."""
    least = min(len(before), len(after))
    start = next((i for i in range(least) if before[i] != after[i]), least)
    end = next((i for i in range(least - start) if before[-1 - i] != after[-1 - i]), least - start)
    return start, len(before) - end, after[start : len(after) - end]
