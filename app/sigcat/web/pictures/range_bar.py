"""The range of a signal as a bar: where it begins and ends, where zero and the default lie."""

from collections.abc import Mapping
from typing import Any, NamedTuple

from sigcat.web.template_filters import scalar

_LEFT, _WIDTH = 8, 304


class Tick(NamedTuple):
    """A mark on the bar, in pixels from its left, with its label."""

    x: float
    label: str
    kind: str
    """`limit`, `zero` or `default`."""
    anchor: str
    """Anchor of the label: start, middle or end at `x`."""


class RangeBar(NamedTuple):
    """A bar that is open to the side without a limit."""

    ticks: tuple[Tick, ...]
    is_open_left: bool
    is_open_right: bool
    summary: str


def range_bar(values: Mapping[str, Any]) -> RangeBar | None:
    """The bar for `min`, `max` and `default`; None without a limit."""
    low, high = _number(values.get("min")), _number(values.get("max"))
    if low is None and high is None:
        return None
    if low is not None and high is not None and high <= low:
        return None
    left, right = _ends(low, high)
    ticks = [Tick(_LEFT, scalar(low), "limit", "start")] if low is not None else []
    ticks += [Tick(_LEFT + _WIDTH, scalar(high), "limit", "end")] if high is not None else []
    default = _number(values.get("default"))
    inner = {"zero": 0 if left < 0 < right else None, "default": default}
    for kind, value in inner.items():
        if value is not None and left <= value <= right:
            ticks.append(
                Tick(round(_LEFT + _WIDTH * (value - left) / (right - left), 1), scalar(value), kind, "middle")
            )
    return RangeBar(tuple(ticks), low is None, high is None, _summary(low, high, default))


def _ends(low: float | None, high: float | None) -> tuple[float, float]:
    """Return the values at the ends of the bar; an open side is as far beyond zero as the limit is before it."""
    if low is None:
        assert high is not None
        return (-high if high > 0 else 2 * high - 1), high
    if high is None:
        return low, (-low if low < 0 else 2 * low + 1)
    return low, high


def _summary(low: float | None, high: float | None, default: float | None) -> str:
    parts = [f"from {scalar(low)}" if low is not None else "", f"to {scalar(high)}" if high is not None else ""]
    parts += [f"default {scalar(default)}"] if default is not None else []
    return "Range " + " ".join(part for part in parts if part)


def _number(value: Any) -> float | None:
    return value if isinstance(value, int | float) and not isinstance(value, bool) and abs(value) < 1e300 else None
