"""A text with the findings beside its lines."""

from collections.abc import Iterable
from typing import NamedTuple

from sigcat.api.answers.schemas import Finding as ShownFinding
from sigcat.api.answers.serializers import finding_schema
from sigcat.findings import SEVERITIES, Finding
from sigcat.limits import PAGE_FINDINGS, PAGE_LINES, PAGE_TEXT_CHARACTERS
from sigcat.text_lines import lines_of

_LINE_CHARACTERS = 500
"""Characters of a line of a text that is not shown whole."""


class Line(NamedTuple):
    """A line of the text."""

    number: int
    text: str
    severity: str
    """The worst of its findings; empty if there are none."""
    findings: tuple[ShownFinding, ...]


class SourceView(NamedTuple):
    """The lines, of a long text only those with findings, and what concerns the text as a whole."""

    lines: tuple[Line, ...]
    general: tuple[ShownFinding, ...]
    is_whole: bool = True


def shown_text(data: bytes) -> str:
    """Return the text of a file for a field of a form: without byte order mark, and with LF at the ends of its lines."""
    return data.decode("utf-8", "replace").removeprefix("\ufeff").replace("\r\n", "\n")


def is_shown_whole(text: str) -> bool:
    """Whether a page repeats a text."""
    return len(text) <= PAGE_TEXT_CHARACTERS and text.count("\n") < PAGE_LINES


def source_view(text: str, findings: Iterable[Finding]) -> SourceView:
    """The lines of a text with their findings. A finding without a line, or beyond the last one, is a general one."""
    texts = lines_of(text) or [""]
    by_line: dict[int, list[ShownFinding]] = {}
    for finding in findings:
        line = finding.line if finding.line <= len(texts) else 0
        by_line.setdefault(line, []).append(finding_schema(finding))
    if not is_shown_whole(text):
        found = sorted(by_line.keys() - {0})[:PAGE_FINDINGS]
        marked = (_line(index, texts[index - 1][:_LINE_CHARACTERS], by_line[index]) for index in found)
        return SourceView(tuple(marked), tuple(by_line.get(0, ())), is_whole=False)
    lines = (_line(index, content, by_line.get(index, [])) for index, content in enumerate(texts, 1))
    return SourceView(tuple(lines), tuple(by_line.get(0, ())))


def _line(index: int, text: str, findings: list[ShownFinding]) -> Line:
    worst = min((finding.severity for finding in findings), key=SEVERITIES.index, default="")
    return Line(index, text, worst, tuple(findings))
