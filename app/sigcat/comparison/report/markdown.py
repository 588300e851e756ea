"""A report as Markdown."""

from collections.abc import Iterator

from sigcat.adapter import text_filters
from sigcat.comparison.report.model import Report
from sigcat.comparison.report.sections import Table, Verbatim, sections


def markdown(report: Report) -> str:
    """The file. Pictures are in the page alone."""
    return "\n".join(_lines(report)) + "\n"


def _lines(report: Report) -> Iterator[str]:
    yield f"# {text_filters.markdown(report.name)} on {text_filters.markdown(', '.join(each.title for each in report.platforms))}"
    yield f"\n{text_filters.markdown(', '.join(report.functions))}; drive {text_filters.markdown_code(report.trace)}; sigcat {report.sigcat}."
    for section in sections(report):
        yield f"\n## {text_filters.markdown(section.title)}"
        for sentence in section.sentences:
            yield f"\n{text_filters.markdown(sentence)}"
        for part in section.parts:
            if isinstance(part, Verbatim):
                yield from _verbatim(part)
            elif isinstance(part, Table):
                yield from _table(part)


def _verbatim(part: Verbatim) -> Iterator[str]:
    """Indented, as no fence is longer than every row of backticks in it."""
    yield f"\n{text_filters.markdown(part.title)}:\n"
    yield from (f"    {line}" for line in part.text.splitlines())


def _table(table: Table) -> Iterator[str]:
    yield f"\n{text_filters.markdown(table.title)}:\n" if table.title else ""
    yield f"| {' | '.join(map(text_filters.markdown, table.head))} |"
    yield f"|{'---|' * len(table.head)}"
    for row in table.rows:
        yield f"| {' | '.join(text_filters.markdown(cell.text) for cell in row)} |"
