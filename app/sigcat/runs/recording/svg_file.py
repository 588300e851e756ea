"""A picture of signals as a self-contained SVG file, in light and in dark."""

from collections.abc import Iterator, Sequence

from sigcat.function.document.text_filters import xml_text
from sigcat.runs.recording.picture import GAP, HEIGHT, LEFT, WIDTH, Panel, Picture

_STYLE = (
    "text{font:12px system-ui,sans-serif;fill:#333}.title{font-weight:600}.label{text-anchor:end}.time{text-anchor:middle}"
    ".frame{fill:none;stroke:#bbb}.mark{stroke:#ddd}.line{fill:none;stroke:#0b62a8;stroke-width:1.5}"
    ".beside{fill:none;stroke:#c2410c;stroke-width:1.5;stroke-dasharray:5 3}.page{fill:#fff}"
    "@media(prefers-color-scheme:dark){text{fill:#ddd}.frame{stroke:#666}.mark{stroke:#444}.line{stroke:#6db3f2}.beside{stroke:#fb923c}.page{fill:#16181a}}"
)


def svg_text(drawn: Picture) -> str:
    """The file."""
    return "\n".join(_lines(drawn)) + "\n"


def stacked(drawn: Sequence[Picture]) -> str:
    """Pictures below each other, each with its own axis of time."""
    width = max((each.width for each in drawn), default=1)
    parts, top = [], 0
    for each in drawn:
        parts.append(f'<svg y="{top}" width="{each.width}" height="{each.height}">\n{svg_text(each)}</svg>')
        top += each.height
    head = f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{max(top, 1)}" role="img">'
    return "\n".join([head, *parts, "</svg>"]) + "\n"


def _lines(drawn: Picture) -> Iterator[str]:
    size = f'width="{drawn.width}" height="{drawn.height}" viewBox="0 0 {drawn.width} {drawn.height}"'
    yield f'<svg xmlns="http://www.w3.org/2000/svg" {size} role="img">'
    yield f"<title>{xml_text(', '.join(panel.title for panel in drawn.panels))}</title>"
    yield f'<style>{_STYLE}</style><rect class="page" width="{drawn.width}" height="{drawn.height}"/>'
    bottom = drawn.panels[-1].top + HEIGHT if drawn.panels else GAP
    for at, label in drawn.ticks:
        yield f'<text class="time" x="{at:g}" y="{bottom + 18}">{xml_text(label)}</text>'
    for panel in drawn.panels:
        yield from _panel(panel, drawn)
    yield f'<text class="time" x="{LEFT + WIDTH / 2:g}" y="{bottom + 34}">seconds</text>'
    yield "</svg>"


def _panel(panel: Panel, drawn: Picture) -> Iterator[str]:
    top = panel.top
    yield f'<text class="title" x="{LEFT}" y="{top - 7}">{xml_text(panel.title)}</text>'
    for at, label in panel.ticks:
        yield f'<path class="mark" d="M{LEFT} {at:g}h{WIDTH}"/>'
        yield f'<text class="label" x="{LEFT - 8}" y="{at + 4:g}">{xml_text(label)}</text>'
    for tick in drawn.ticks:
        yield f'<path class="mark" d="M{tick.at:g} {top}v{HEIGHT}"/>'
    yield f'<rect class="frame" x="{LEFT}" y="{top}" width="{WIDTH}" height="{HEIGHT}"/>'
    if panel.beside:
        yield f'<path class="beside" d="{panel.beside}"/>'
    if panel.path:
        yield f'<path class="line" d="{panel.path}"/>'
