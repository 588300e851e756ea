"""An unknown unit: the one that is meant, or how to define it."""

import pytest

from sigcat.catalogue.model.common_units import _QUANTITIES, quantity_advice
from sigcat.catalogue.model.near_units import advice
from sigcat.catalogue.model.vocabulary import STANDARD_QUANTITIES, STANDARD_UNITS, read_vocabulary

VSS = read_vocabulary([STANDARD_UNITS], [STANDARD_QUANTITIES])


@pytest.mark.parametrize(
    ("name", "key"),
    [("degC", "Celsius"), ("°C", "Celsius"), ("Cel", "Celsius"), ("kmh", "km/h"), ("m/s²", "m/s^2"), ("%", "percent"),
     ("1/min", "rpm"), ("[in_i]", "inch"), ("hPa", "mbar"), ("cm3", "cm^3"), ("lb", "lbs")],
)  # fmt: skip
def test_another_spelling_means_a_unit_of_vss(name, key):
    assert advice(name, VSS).startswith(f"Write `{key}`: ")


@pytest.mark.parametrize(
    ("name", "others", "definition"),
    [
        ("K", "temperature (Celsius, Fahrenheit)", "K: {definition: Kelvin., unit: kelvin, quantity: temperature"),
        ("mA", "electric-current (A)", "mA: {definition: Milliampere., unit: milliampere, quantity: electric-current"),
        (
            "ppm",
            "relation (ratio, ",
            "ppm: {definition: Parts per million., unit: parts per million, quantity: relation",
        ),
    ],
)
def test_a_common_unit_that_vss_does_not_define_is_defined(name, others, definition):
    text = advice(name, VSS)
    assert f"Use a unit of {others}" in text
    assert definition in text


def test_the_definition_of_a_unit_can_be_used_as_it_is(tmp_path):
    for name in ("K", "ug/m3", "ppm", "mA", "µg/m³"):
        parts = advice(name, VSS).split("`")[1::2]
        quantities = [part for part in parts if "quantity" not in part and "{" in part]
        (tmp_path / "quantities.yaml").write_text("\n".join(quantities or ["smell: {definition: A smell.}"]))
        (tmp_path / "units.yaml").write_text("".join(f"{part}\n" for part in parts if "quantity" in part))
        made = read_vocabulary([tmp_path / "units.yaml"], [tmp_path / "quantities.yaml"])
        assert made.findings == ()
        assert len(made.distinct_units) == 1


@pytest.mark.parametrize("name", ["foo bar", "a'b", "x\ny", "bar/s"])
def test_the_quantity_of_an_unknown_unit_is_not_guessed(name, tmp_path):
    _, definition, _ = advice(name, VSS).rsplit("`", 2)
    (tmp_path / "units.yaml").write_text(f"{definition}\n")
    (finding,) = read_vocabulary([tmp_path / "units.yaml"], []).findings
    assert (finding.rule, "KEY_OF_QUANTITY" in finding.message) == ("U002", True)


def test_a_name_that_is_nearly_right_is_proposed():
    assert advice("celcius", VSS) == "Did you mean 'Celsius' (degree Celsius)?"


@pytest.mark.parametrize(
    ("quantity", "unit", "meant"),
    [("energy", "J", "work"), ("Energy", "foo", "work"), ("flow_rate", "foo", "volume-flow-rate"),
     ("speed", "mph", "velocity"), ("velocty", "foo", "velocity"), ("share", "ppm", "relation")],
)  # fmt: skip
def test_the_quantity_of_a_unit_is_the_one_that_vss_has(quantity, unit, meant):
    assert quantity_advice(quantity, unit, "", VSS.quantities) == f"Did you mean {meant!r}?"


def test_a_quantity_without_another_name_is_defined():
    assert quantity_advice("smell", "foo", "", VSS.quantities).startswith("Define it in a quantities.yaml")


def test_other_names_of_quantities_mean_quantities_of_vss():
    assert set(_QUANTITIES) <= set(VSS.quantities)
    assert not {name for text in _QUANTITIES.values() for name in text.split()} & set(VSS.quantities)
