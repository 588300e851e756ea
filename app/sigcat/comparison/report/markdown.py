"""A report as Markdown."""

from collections.abc import Iterator

from sigcat.comparison.report.model import Report
from sigcat.comparison.report.sections import Table, Verbatim, sections


def markdown(report: Report) -> str:
    """The file. Pictures are in the page alone."""
    return "\n".join(_lines(report)) + "\n"


def _lines(report: Report) -> Iterator[str]:
    yield f"# {_plain(report.name)} on {', '.join(each.title for each in report.platforms)}"
    yield f"\n{', '.join(report.functions)}; drive `{_plain(report.trace)}`; sigcat {report.sigcat}."
    for section in sections(report):
        yield f"\n## {section.title}"
        for sentence in section.sentences:
            yield f"\n{_plain(sentence)}"
        for part in section.parts:
            if isinstance(part, Verbatim):
                yield from _verbatim(part)
            elif isinstance(part, Table):
                yield from _table(part)


def _verbatim(part: Verbatim) -> Iterator[str]:
    """Indented, as no fence is longer than every row of backticks in it."""
    yield f"\n{_plain(part.title)}:\n"
    yield from (f"    {line}" for line in part.text.splitlines())


def _table(table: Table) -> Iterator[str]:
    yield f"\n{table.title}:\n" if table.title else ""
    yield f"| {' | '.join(map(_plain, table.head))} |"
    yield f"|{'---|' * len(table.head)}"
    for row in table.rows:
        yield f"| {' | '.join(_plain(cell.text) for cell in row)} |"


def _plain(text: str) -> str:
    """Text that is nothing else in Markdown, and stays in its cell."""
    escaped = "".join(f"\\{each}" if each in "\\`*_[]<>|#" else each for each in text)
    return " ".join(escaped.split())
