"""A baseline: findings that a tree has already, so that only new ones are reported.

Entries name a rule and a path, not a line: they stay true when the node moves. A finding that is about no node is named
by its file.
"""

import json
from collections import Counter
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple

from sigcat import codes
from sigcat.errors import InputRefused
from sigcat.findings import Finding
from sigcat.real_path import real_path

VERSION = 1


class Baseline(NamedTuple):
    """Number of known findings of each rule at each path."""

    file: str
    known: Counter[tuple[str, str]]
    paths: tuple[str, ...] = ()
    """Paths that were linted when it was written, relative to the root; nothing in a file without them."""


class Compared(NamedTuple):
    """New findings, how many were known, and a finding for each entry that no longer has one."""

    findings: tuple[Finding, ...]
    known: int
    stale: tuple[Finding, ...]


def baseline_text(findings: Iterable[Finding], root: Path, paths: Iterable[Path] = ()) -> str:
    """The content of a baseline file for these findings, which a lint of `paths` made."""
    counts = Counter(_key(finding, root) for finding in findings)
    entries = [{"rule": rule, "path": path, "count": count} for (rule, path), count in sorted(counts.items())]
    linted = [_within(path, root) for path in paths]
    return json.dumps({"version": VERSION, "paths": linted, "findings": entries}, indent=2) + "\n"


def read_baseline(path: Path) -> Baseline:
    """Read a baseline file. Raises InputRefused."""
    try:
        data = json.loads(path.read_bytes())
        known: Counter[tuple[str, str]] = Counter()
        for entry in _entries(data):
            known[(str(entry["rule"]), str(entry["path"]))] += int(entry.get("count", 1))
        paths = tuple(map(str, data.get("paths", ())))
    except OSError as error:
        raise InputRefused(f"The baseline {str(path)!r} cannot be read: {error.strerror}.") from None
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError):
        raise InputRefused(f"{str(path)!r} is not a baseline. Write one with `sigcat lint --write-baseline`.") from None
    return Baseline(str(path), known, paths)


def covers(paths: Iterable[Path], baseline: Baseline, root: Path) -> bool:
    """Whether a lint of `paths` looks at all that was looked at when the baseline was written."""
    named = [real_path(path) for path in paths]
    written = [(root / path).resolve() for path in baseline.paths]
    return all(any(path == name or name in path.parents for name in named) for path in written)


def compare(findings: Iterable[Finding], baseline: Baseline, root: Path, *, complete: bool = True) -> Compared:
    """Leave out what the baseline knows. Without `complete`, part of the tree was linted, and no entry is stale."""
    left = Counter(baseline.known)
    new = []
    known = 0
    for finding in findings:
        key = _key(finding, root)
        if left[key] > 0:
            left[key] -= 1
            known += 1
        else:
            new.append(finding)
    stale = [
        codes.BASELINE_STALE.finding(f"{rule} at {path!r} is no longer found.", baseline.file, path=path, fix="Write the baseline again.")
        for (rule, path), count in sorted(left.items())
        if count > 0 and complete
    ]  # fmt: skip
    return Compared(tuple(new), known, tuple(stale))


def _key(finding: Finding, root: Path) -> tuple[str, str]:
    return finding.rule, finding.path or _within(Path(finding.file), root)


def _within(path: Path, root: Path) -> str:
    try:
        return real_path(path).relative_to(real_path(root)).as_posix()
    except ValueError:
        return str(path)


def _entries(data: Any) -> list[Any]:
    entries = data["findings"]
    if not isinstance(entries, list):
        raise TypeError
    return entries
