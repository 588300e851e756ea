"""Values and times of a run as readers see them."""

from sigcat.adapter.host.shapes import Number, Shape
from sigcat.runs.recording.times import seconds
from sigcat.web.template_filters import number


def seconds_text(time: int) -> str:
    """A time in ns as seconds, with the digits that it needs."""
    return seconds(time).rstrip("0").rstrip(".")


def word_of(value: float, shape: Shape) -> str:
    """A value as its symbol, as true or false, or as a number."""
    assert isinstance(shape, Number)
    if shape.datatype == "boolean" and not shape.symbols:
        return "true" if value else "false"
    symbol = next((symbol for symbol, given in shape.symbols if given == value), None)
    return symbol or ("no number" if value != value else number(value))  # noqa: PLR0124 - NaN
