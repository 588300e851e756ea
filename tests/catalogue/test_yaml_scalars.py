"""Scalars as YAML 1.1 has them."""

import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

from sigcat.catalogue.reading.yaml_scalars import number_advice, yaml_number
from tests.properties import examples


@examples(200)
@given(st.one_of(st.floats(allow_nan=False, allow_infinity=False), st.integers(-(10**20), 10**20)))
def test_a_number_is_written_as_yaml_reads_it(number):
    assert yaml.safe_load(yaml_number(number)) == number
    assert type(yaml.safe_load(yaml_number(number))) is type(number)


@pytest.mark.parametrize("text", ["1e300", "1e3", "1.0e3", "1e+3", ".5e3", "-2E5"])
def test_an_exponent_without_a_point_or_a_sign_is_explained(text):
    assert isinstance(yaml.safe_load(text), str)
    advice = number_advice(text)
    number = advice.removeprefix("Write ").partition(":")[0]
    assert yaml.safe_load(number) == float(text)
    assert f"YAML reads {text} as a text" in advice


def test_a_whole_number_is_advised_where_one_is_expected():
    assert number_advice("1e3", is_whole=True).startswith("Write 1000: ")
    assert number_advice("1e-3", is_whole=True) == ""


@pytest.mark.parametrize("text", ["100", "-1.5", "1.0e+3"])
def test_a_number_in_quotes_is_written_without(text):
    assert number_advice(text).endswith(", without quotes.")


@pytest.mark.parametrize("text", ["abc", "", "1e400", "9" * 6000, "0x10", "1 ms 2", "1,000,000", "nan", "-", "e5"])
def test_other_texts_have_no_advice(text):
    assert number_advice(text) == ""


@pytest.mark.parametrize(("text", "unit"), [("40ms", "ms"), ("-1.5 km/h", "km/h"), ("20%", "%"), ("3 °", "°")])
def test_a_number_with_a_unit_is_written_without(text, unit):
    assert number_advice(text) == f"Write the number without '{unit}', in the unit of the field."


def test_a_number_with_a_comma_is_written_with_a_point():
    assert number_advice("-1,5") == "Write -1.5, with a point."


@pytest.mark.parametrize("text", ["1e-400", "-2.5E-330", "0.1e-350"])
def test_a_number_that_a_double_rounds_to_0_is_not_advised_as_0(text):
    assert number_advice(text) == "Write a number of at least 5.0e-324: a double has none between it and 0."


@pytest.mark.parametrize("text", ["0e5", "0.0e-400"])
def test_a_zero_stays_one(text):
    assert number_advice(text).startswith("Write 0.0")
