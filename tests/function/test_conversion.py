"""Conversions between units are exact."""

from fractions import Fraction

import pytest

from sigcat.catalogue.model.vocabulary import read_vocabulary
from sigcat.data import OVERLAYS, VSPEC
from sigcat.function.function_json.conversion import _TO_BASE, Linear, as_text, between

UNITS = read_vocabulary([VSPEC / "units.yaml", OVERLAYS / "units.yaml"], [VSPEC / "quantities.yaml"])


@pytest.mark.parametrize(
    ("value", "source", "target", "expected"),
    [
        (36, "km/h", "m/s", 10),
        (10, "m/s", "km/h", 36),
        (1, "inch", "mm", Fraction("25.4")),
        (212, "Fahrenheit", "Celsius", 100),
        (0, "Celsius", "Fahrenheit", 32),
        (1, "bar", "kPa", 100),
        (5, "rpm", "degrees/s", 30),
        (50, "percent", "ratio", Fraction(1, 2)),
        (7, "kg", "kg", 7),
    ],
)
def test_values_are_converted_without_rounding(value, source, target, expected):
    conversion = between(source, target)
    assert conversion is not None
    assert conversion(value) == expected
    assert conversion.inverse(expected) == value


def test_radians_are_converted_to_the_nearest_double():
    conversion = between("degrees", "radians")
    assert conversion is not None
    assert float(conversion(180)) == pytest.approx(3.141592653589793, rel=1e-15)


@pytest.mark.parametrize(("source", "target"), [("km/h", "kg"), ("mpg-us", "l/100km"), ("nothing", "m")])
def test_what_has_no_linear_way_is_not_converted(source, target):
    assert between(source, target) is None


def test_every_unit_of_the_table_is_one_of_the_vocabulary_and_of_one_kind():
    assert _TO_BASE
    for units in _TO_BASE.values():
        known = {key: UNITS.unit(key) for key in units}
        assert None not in known.values(), [key for key, unit in known.items() if unit is None]
        quantities = {unit.quantity for unit in known.values() if unit}
        assert quantities in ({"angular-speed", "rotational-speed"}, {"relation"}) or len(quantities) == 1


@pytest.mark.parametrize(
    ("number", "text"),
    [
        (Fraction(5), "5"),
        (Fraction("3.6"), "3.6"),
        (Fraction("-0.05"), "-0.05"),
        (Fraction(1, 3), "0.3333333333333333"),
        (Fraction(1, 2**60), "0.000000000000000000867361737988403547205962240695953369140625"),
        (Fraction(0), "0"),
    ],
)
def test_numbers_are_written_exactly_where_they_have_an_end(number, text):
    assert as_text(number) == text
    assert as_text(Linear(number).factor) == text
