"""Types that every platform has (AUTOSAR_SWS_PlatformTypes), and the values that they hold."""

from collections.abc import Mapping

_WIDTHS = (8, 16, 32, 64)

WHOLE_NUMBERS: Mapping[str, tuple[int, int]] = {
    "boolean": (0, 1),
    **{f"uint{bits}": (0, 2**bits - 1) for bits in _WIDTHS},
    **{f"sint{bits}": (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1) for bits in _WIDTHS},
}
"""The smallest and the largest value, by type."""

FLOATS: Mapping[str, float] = {"float32": 3.4028234663852886e38, "float64": 1.7976931348623157e308}
"""The largest value, by type."""
