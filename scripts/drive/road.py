"""The road: hills and curves along the way."""

from collections.abc import Sequence
from typing import NamedTuple


class Hill(NamedTuple):
    """A part of the road that leads up, or down."""

    begin: float
    length: float
    height: float


class Curve(NamedTuple):
    """A part of the road that is bent, to the left if the radius is positive. It is straight at both ends."""

    begin: float
    length: float
    radius: float


HILLS = (
    Hill(500, 400, 9),
    Hill(1000, 800, 30),
    Hill(1900, 400, -8),
    Hill(2400, 900, -38),
    Hill(3400, 1100, 50),
    Hill(4700, 500, 12),
    Hill(5200, 1000, -46),
    Hill(6300, 800, -24),
    Hill(7300, 400, 8),
    Hill(8000, 1000, 44),
    Hill(9100, 400, -10),
    Hill(9600, 900, -34),
    Hill(10700, 800, 30),
    Hill(11700, 1100, -48),
    Hill(13000, 700, 18),
    Hill(13800, 600, -14),
)
CURVES = (
    Curve(1500, 300, 500),
    Curve(4300, 400, -700),
    Curve(6450, 260, 160),
    Curve(6900, 300, -130),
    Curve(7450, 240, 220),
    Curve(11300, 400, -450),
    Curve(13300, 300, 300),
)
BEND = 60.0
"""Meters from straight to bent."""


def smooth(share: float) -> float:
    """From 0 to 1, level at both ends."""
    inside = min(1.0, max(0.0, share))
    return inside * inside * (3.0 - 2.0 * inside)


def altitude(way: float, hills: Sequence[Hill] = HILLS) -> float:
    """In meters above sea level, after so many meters."""
    return 260.0 + sum(hill.height * smooth((way - hill.begin) / hill.length) for hill in hills)


def curvature(way: float, curves: Sequence[Curve] = CURVES) -> float:
    """In 1/m, positive to the left."""
    return sum(bend(way, curve) / curve.radius for curve in curves)


def bend(way: float, curve: Curve) -> float:
    """Curvature at a position: 0 is straight, 1 is the curve's radius."""
    entered = smooth((way - curve.begin) / BEND)
    left = smooth((way - curve.begin - curve.length + BEND) / BEND)
    return entered - left
