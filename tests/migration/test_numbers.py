"""Numbers in another unit keep their meaning: exact if they end, else short, and restored on the way back."""

from fractions import Fraction

import pytest
from hypothesis import given
from hypothesis import strategies as st

from sigcat.function.function_json.conversion import Linear, between
from sigcat.migration.numbers import converted, converted_value


def _linear(source: str, target: str) -> Linear:
    linear = between(source, target)
    assert linear is not None
    return linear


def _fraction(text: str | None) -> Fraction:
    assert text is not None
    return Fraction(text)


@pytest.mark.parametrize(
    ("text", "source", "target", "expected"),
    [
        ("100", "km/h", "m/s", "27.78"),
        ("27.78", "m/s", "km/h", "100"),
        ("36", "km/h", "m/s", "10"),
        ("0.5", "km", "m", "500"),
        ("-40", "celsius", "fahrenheit", "-40"),
        ("1e3", "m", "km", "1"),
        ("x", "km", "m", None),
    ],
)
def test_a_limit(text, source, target, expected):
    assert converted(text, _linear(source, target)) == expected


UNITS = st.sampled_from(
    [("km/h", "m/s"), ("km", "m"), ("celsius", "fahrenheit"), ("degrees", "radians"), ("psi", "kpa")]
)
NUMBERS = st.decimals(min_value=-1000, max_value=1000, places=2).map(str)


@given(NUMBERS, UNITS)
def test_a_limit_differs_by_less_than_half_of_its_last_digit(text, units):
    conversion = _linear(*units)
    back = conversion.inverse(_fraction(converted(text, conversion)))
    assert abs(back - Fraction(text)) <= Fraction(1, 200)


@given(NUMBERS, UNITS)
def test_a_recorded_value_is_restored(text, units):
    conversion = _linear(*units)
    there = converted_value(text, conversion)
    assert there is not None
    assert _fraction(converted_value(there, conversion.inverse)) == Fraction(text)
