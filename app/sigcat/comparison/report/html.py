"""A report as HTML: a part for any page, and a page without scripts or external files."""

from collections.abc import Iterator
from html import escape

from sigcat.comparison.report.model import Report
from sigcat.comparison.report.sections import Cell, Picture, Section, Table, Verbatim, sections
from sigcat.comparison.report.style import STYLE


def html_page(report: Report) -> str:
    """The file."""
    title = escape(f"{report.name}: comparison of platforms")
    policy = "default-src 'none'; style-src 'unsafe-inline'"
    return (
        '<!doctype html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n<meta name="color-scheme" content="light dark">\n'
        f"<title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n<h1>{title}</h1>\n{fragment(report)}</main>\n"
        "</body>\n</html>\n"
    )


def fragment(report: Report) -> str:
    """Everything below the heading."""
    return "\n".join(_lines(report)) + "\n"


def _lines(report: Report) -> Iterator[str]:
    of = f"{', '.join(report.functions)}; drive {report.trace}; sigcat {report.sigcat}"
    yield f'<p class="muted">{escape(of)}</p>'
    made = sections(report)
    links = "".join(f'<li><a href="#{_anchor(each)}">{escape(each.title)}</a></li>' for each in made)
    yield f'<nav aria-label="Parts of the report"><ul class="chips">{links}</ul></nav>'
    for section in made:
        yield f'<h2 id="{_anchor(section)}">{escape(section.title)}</h2>'
        for sentence in section.sentences:
            yield f'<p class="remark">{escape(sentence)}</p>'
        for part in sorted(section.parts, key=_place):
            yield _part(part)


def _place(part: Table | Picture | Verbatim) -> int:
    """Place within a section: what shows at once, pictures, then folded tables."""
    return 2 if isinstance(part, Table) and not part.is_shown else 1 if isinstance(part, Picture) else 0


def _anchor(section: Section) -> str:
    return section.title.lower().replace(" ", "-")


def _part(part: Table | Picture | Verbatim) -> str:
    if isinstance(part, Picture):
        return _picture(part)
    return _table(part) if isinstance(part, Table) else _verbatim(part)


def _verbatim(part: Verbatim) -> str:
    label = escape(part.title)
    return f'<h3>{label}</h3>\n<pre tabindex="0" role="region" aria-label="{label}">{escape(part.text)}</pre>'


def _picture(part: Picture) -> str:
    label = escape(part.caption)
    return (
        f'<figure><div class="scroll picture" tabindex="0" role="region" aria-label="{label}">{part.svg}</div>'
        f"<figcaption>{label}</figcaption></figure>"
    )


def _table(table: Table) -> str:
    head = "".join(f'<th scope="col">{escape(each) or _UNSEEN}</th>' for each in table.head)
    rows = "".join(_row(row, table) for row in table.rows)
    text = (
        f'<div class="scroll" tabindex="0" role="region" aria-label="{escape(table.title)}"><table class="wide stacked{" summary" if table.is_shown else ""}">'
        f"<thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table></div>"
    )
    return text if table.is_shown else f"<details><summary>{escape(table.title)}</summary>{text}</details>"


_UNSEEN = '<span class="unseen">state</span>'


def _row(row: tuple[Cell, ...], table: Table) -> str:
    first, *rest = row
    cells = "".join(_cell(cell, name) for cell, name in zip(rest, table.head[1:], strict=False))
    return f'<tr><th scope="row">{_breakable(first.text)}</th>{cells}</tr>'


def _cell(cell: Cell, name: str) -> str:
    tone = f' class="{cell.tone}"' if cell.tone else ""
    label = f' data-label="{escape(name)}"' if name else ""
    return f"<td{label}{tone}>{_breakable(cell.text)}</td>"


def _breakable(text: str) -> str:
    """Long names may break where a word of them ends."""
    return escape(text).replace("_", "_<wbr>").replace(".", ".<wbr>") if " " not in text else escape(text)
