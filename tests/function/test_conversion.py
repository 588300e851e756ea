"""Conversions between units are exact."""

from fractions import Fraction

import pytest

from sigcat.catalogue.model.vocabulary import read_vocabulary
from sigcat.data import OVERLAYS, VSPEC
from sigcat.function.function_json.conversion import _TO_BASE, Linear, as_decimal, as_text, between, of_text
from sigcat.function.resolving.values.numbers import shown

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


def test_a_message_shows_a_number_that_is_larger_than_any_double():
    assert shown(Fraction("1.7976931348623157e308") * Fraction(18, 5)) == "6.472e+308"
    assert shown(-(Fraction(10) ** 309) / 3) == "-3.333e+308"


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
        (Fraction(1, 3), "1/3"),
        (Fraction(-160, 9), "-160/9"),
        (Fraction(1, 2**60), "0.000000000000000000867361737988403547205962240695953369140625"),
        (Fraction(0), "0"),
    ],
)
def test_numbers_are_written_exactly_where_they_have_an_end(number, text):
    assert as_text(number) == text
    assert as_text(Linear(number).factor) == text
    assert of_text(text) == number


PAIRS = [(source, target) for units in _TO_BASE.values() for source in units for target in units if source != target]
PI = Fraction("3.14159265358979323846264338327950288419716939937510")


def test_what_is_carried_has_the_nearest_double_of_each_direction():
    for pair in PAIRS:
        linear, back = between(*pair), between(*reversed(pair))
        assert linear is not None, pair
        assert back is not None, pair
        factor, offset = of_text(as_text(linear.factor)), of_text(as_text(linear.offset))
        assert factor is not None, pair
        assert offset is not None, pair
        carried = Linear(factor, offset)
        assert (carried, carried.inverse) == (linear, back), pair
        ends = [float(as_decimal(end)) for end in (*carried, *carried.inverse)]
        assert ends == [float(end) for end in (*linear, *back)], pair


@pytest.mark.parametrize(
    ("source", "target", "exact"),
    [
        ("degrees", "radians", PI / 180),
        ("radians", "degrees", 180 / PI),
        ("rpm", "rad/s", PI / 30),
        ("rad/s", "rpm", 30 / PI),
        ("rad/s", "degrees/s", 180 / PI),
    ],
)
def test_the_ratio_of_radians_is_the_nearest_double(source, target, exact):
    conversion = between(source, target)
    assert conversion is not None
    assert float(conversion.factor) == float(exact)


@pytest.mark.parametrize(
    ("text", "number"),
    [
        (" 3.6 ", Fraction("3.6")),
        ("1e-5", Fraction("1e-5")),
        ("-5/18", Fraction(-5, 18)),
        ("1e400", None),
        ("1e999999999", None),
        ("1e-999", 0),
        ("1/0", None),
        ("nan", None),
        ("1_0", None),
        ("", None),
    ],
)
def test_a_number_of_a_document_is_read_as_it_stands_there(text, number):
    assert of_text(text) == number
