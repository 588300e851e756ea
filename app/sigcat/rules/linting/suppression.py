"""Comments that suppress findings.

`# sigcat: ignore[CODE, …]` at the end of a line concerns that line. On a separate line it concerns the block that
starts on the next line: all lines indented deeper than that one. `# sigcat: ignore-file[CODE, …]` concerns the file.
"""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import lru_cache, partial
from itertools import pairwise
from typing import NamedTuple

from sigcat import codes
from sigcat.findings import Finding
from sigcat.names import did_you_mean
from sigcat.rules.problem import Repair
from sigcat.text_lines import lines_of

MARK = b"sigcat:"

_COMMENT = r"#\s*sigcat:\s*(?P<what>[\w-]*)\s*(?:\[(?P<codes>[^\]\n]*)\])?(?P<rest>[^\r\n]*)"
_CODE = r"[A-Z]+[0-9]*"


class Suppression(NamedTuple):
    """A comment that suppresses `codes` on the lines from `first` to `last`; `line` and `column` are its own."""

    codes: tuple[str, ...]
    first: int
    last: int
    line: int
    column: int


class Suppressions(NamedTuple):
    """The suppressions of one file, and the comments that cannot be read as such."""

    file: str
    entries: tuple[Suppression, ...]
    findings: tuple[Finding, ...]


class Kept(NamedTuple):
    """The findings that are left, how many were suppressed, and the errors of the comments themselves."""

    findings: tuple[Finding, ...]
    suppressed: int
    about_comments: tuple[Finding, ...]
    unused: tuple[tuple[Finding, Repair], ...]
    """Findings of `about_comments` that a repair settles."""


def read_suppressions(text: str, file: str, known: Sequence[str]) -> Suppressions:
    """The suppressions in the text of a file. `known` are the codes of all rules."""
    if MARK.decode() not in text:
        return Suppressions(file, (), ())
    lines = lines_of(text)
    blocks = _blocks_of(lines)
    codes_of = lru_cache(partial(_codes, known=known))
    entries: list[Suppression] = []
    findings: list[Finding] = []
    for number, line in enumerate(lines, 1):
        if MARK.decode() not in line:
            continue
        for match in re.finditer(_COMMENT, line):
            named, problem = codes_of(match["what"], match["codes"] or "")
            column = match.start() + 1
            if problem:
                findings.append(codes.SUPPRESSION_MALFORMED.finding(problem, file, number, column))
            if named:
                first, last = _reach(match, number, lines, blocks)
                entries.append(Suppression(named, first, last, number, column))
    return Suppressions(file, tuple(entries), tuple(findings))


def apply_suppressions(
    findings: Iterable[Finding], suppressions: Iterable[Suppressions], active: Iterable[str]
) -> Kept:
    """Leave out what is suppressed. A code that suppressed nothing, of a rule that ran, is a finding itself."""
    by_file = {entry.file: entry for entry in suppressions}
    used: set[tuple[str, int, int, str]] = set()
    kept = []
    suppressed = 0
    for finding in findings:
        entry = by_file.get(finding.file)
        hits = list(_hits(finding, entry)) if entry is not None else []
        used.update((finding.file, *hit) for hit in hits)
        suppressed += bool(hits)
        if not hits:
            kept.append(finding)
    about = [finding for entry in by_file.values() for finding in entry.findings]
    unused = tuple(_unused(by_file.values(), used, frozenset(active)))
    return Kept(tuple(kept), suppressed, (*about, *(finding for finding, _ in unused)), unused)


def without_codes(line: str, column: int, codes: Iterable[str]) -> str:
    """The line without these codes in the comment at `column` (from 1); without the comment where it has no others.

    A line that says nothing else is left empty.
    """
    match = re.compile(_COMMENT).match(line, column - 1)
    if match is None:
        return line
    unwanted = set(codes)
    left = [code.strip() for code in match["codes"].split(",") if code.strip() and code.strip() not in unwanted]
    if left:
        start, end = match.span("codes")
        return f"{line[:start]}{', '.join(left)}{line[end:]}"
    return line[: match.start()].rstrip() + line[match.end() :]


def _hits(finding: Finding, entry: Suppressions) -> Iterator[tuple[int, int, str]]:
    for suppression in entry.entries:
        if suppression.first <= finding.line <= suppression.last or suppression.first == 0:
            for code in suppression.codes:
                if finding.rule.startswith(code):
                    yield suppression.line, suppression.column, code


def _unused(
    entries: Iterable[Suppressions], used: set[tuple[str, int, int, str]], active: frozenset[str]
) -> Iterator[tuple[Finding, Repair]]:
    ran = lru_cache(lambda code: any(rule.startswith(code) for rule in active))
    for entry in entries:
        for suppression in entry.entries:
            for code in suppression.codes:
                if ran(code) and (entry.file, suppression.line, suppression.column, code) not in used:
                    message = f"`ignore[{code}]` suppresses nothing."
                    at = (entry.file, suppression.line, suppression.column)
                    finding = codes.SUPPRESSION_UNUSED.finding(message, *at, fix="Remove it.")
                    yield finding, Repair("remove suppression", code)


def _codes(what: str, listed: str, known: Sequence[str]) -> tuple[tuple[str, ...], str]:
    """Codes that a comment lists, and its problem. `known` are the codes of all rules."""
    if what not in ("ignore", "ignore-file"):
        hint = did_you_mean(what, ("ignore", "ignore-file"))
        return (), f"A comment must say `ignore` or `ignore-file`, not {what!r}. {hint}".strip()
    named = [code.strip() for code in listed.split(",") if code.strip()]
    if not named:
        return (), f"The comment must name codes, as in `sigcat: {what}[CODE]`."
    good = tuple(code for code in named if re.fullmatch(_CODE, code) and any(rule.startswith(code) for rule in known))
    bad = [code for code in named if code not in good]
    hint = did_you_mean(bad[0], known) if bad else ""
    return good, f"No rule has the code {bad[0]!r}. {hint}".strip() if bad else ""


def _reach(match: re.Match[str], number: int, lines: Sequence[str], blocks: "_Blocks") -> tuple[int, int]:
    """First and last line that the comment concerns; 0 and 0 for the whole file."""
    if match["what"] == "ignore-file":
        return 0, 0
    start = blocks.following[number]
    if lines[number - 1][: match.start()].strip() or start == len(lines):
        return number, number
    return start + 1, blocks.last[start] + 1


class _Blocks(NamedTuple):
    """Starts and ends of blocks. Lines count from 0; their number is the line after the last one."""

    following: Sequence[int]
    """For each line, the first one from it on that says something."""
    last: Mapping[int, int]
    """For each line that says something, the last one below it that is indented more, or itself."""


def _blocks_of(lines: Sequence[str]) -> _Blocks:
    following, last, around = [len(lines)] * (len(lines) + 1), {}, list[int]()
    for line in reversed(range(len(lines))):
        following[line] = line if _says_something(lines[line]) else following[line + 1]
    saying = [line for line in range(len(lines)) if following[line] == line]
    for before, line in pairwise([-1, *saying, len(lines)]):
        indentation = _indentation(lines[line]) if line < len(lines) else -1
        while around and _indentation(lines[around[-1]]) >= indentation:
            last[around.pop()] = before
        around.append(line)
    return _Blocks(following, last)


def _says_something(line: str) -> bool:
    stripped = line.strip()
    return bool(stripped) and not stripped.startswith("#")


def _indentation(line: str) -> int:
    return len(line) - len(line.lstrip())
