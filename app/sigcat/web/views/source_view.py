"""A text with the findings beside its lines."""

from collections.abc import Iterable
from typing import NamedTuple

from sigcat.api.answers.schemas import Finding as ShownFinding
from sigcat.api.answers.serializers import finding_schema
from sigcat.findings import SEVERITIES, Finding


class Line(NamedTuple):
    """A line of the text."""

    number: int
    text: str
    severity: str
    """The worst of its findings; empty if there are none."""
    findings: tuple[ShownFinding, ...]


class SourceView(NamedTuple):
    """All lines, and what concerns the text as a whole."""

    lines: tuple[Line, ...]
    general: tuple[ShownFinding, ...]


def shown_text(data: bytes) -> str:
    """What a file holds as a field of a form takes it: without byte order mark, and LF at the ends of its lines."""
    return data.decode("utf-8", "replace").removeprefix("\ufeff").replace("\r\n", "\n")


def source_view(text: str, findings: Iterable[Finding]) -> SourceView:
    """The lines of a text with their findings. A finding without a line, or beyond the last one, is a general one."""
    texts = text.splitlines() or [""]
    by_line: dict[int, list[ShownFinding]] = {}
    for finding in findings:
        line = finding.line if finding.line <= len(texts) else 0
        by_line.setdefault(line, []).append(finding_schema(finding))
    lines = (_line(index, content, by_line.get(index, [])) for index, content in enumerate(texts, 1))
    return SourceView(tuple(lines), tuple(by_line.get(0, ())))


def _line(index: int, text: str, findings: list[ShownFinding]) -> Line:
    worst = min((finding.severity for finding in findings), key=SEVERITIES.index, default="")
    return Line(index, text, worst, tuple(findings))
