"""Every unit of VSS is known in SI units, or known to have no factor to them."""

from fractions import Fraction

import pytest
import yaml

from sigcat.data import VSPEC
from sigcat.function.function_json.conversion import between
from sigcat.integration.autosar_si_units import WITHOUT_SI, Dimension, UnitSettings, si_unit

UNITS = sorted(yaml.safe_load((VSPEC / "units.yaml").read_text(encoding="utf-8")))
NEWER = ["ns", "us", "hPa", "celsius", "bpm"]

IN_SI: dict[str, tuple[int, int | Fraction | None]] = {
    # unit: value in it, the same in SI units
    "km/h": (36, 10), "Celsius": (20, Fraction("293.15")), "Fahrenheit": (212, Fraction("373.15")), "rpm": (60, None),
    "mbar": (1000, 100_000), "hPa": (1, 100), "kWh": (1, 3_600_000), "Ah": (2, 7200), "l/h": (3600, Fraction("0.001")),
    "percent": (50, Fraction("0.5")), "PS": (1, Fraction("735.49875")), "inch": (1, Fraction("0.0254")),
    "l/100km": (1, Fraction(1, 10**8)), "km/l": (1, 10**6), "ms": (5, Fraction("0.005")), "Nm": (7, 7), "cm^3": (1, Fraction(1, 10**6)),
    "kWh/100km": (1, 36), "mm/h": (3_600_000, 1), "g/km": (1000, Fraction(1, 1000)), "bpm": (60, 1), "lbs": (1, Fraction("0.45359237")),
}  # fmt: skip


def known(unit):
    found = si_unit(unit)
    assert found is not None
    return found


@pytest.mark.parametrize("unit", [*UNITS, *NEWER])
def test_a_unit_of_vss_is_known_or_has_no_factor(unit):
    assert (si_unit(unit) is None) == (unit in WITHOUT_SI)


@pytest.mark.parametrize("unit", IN_SI)
def test_values_in_si_units_become_values_in_the_unit(unit):
    value, in_si = IN_SI[unit]
    if in_si is not None:
        assert known(unit).from_si(in_si) == value
    else:
        assert float(known(unit).from_si(6.283185307179586)) == pytest.approx(value)


def test_units_that_functions_convert_between_agree_with_their_conversion():
    convertible = [(a, b) for a in UNITS for b in UNITS if a != b and between(a, b) is not None and si_unit(a)]
    assert len(convertible) > 80
    for a, b in convertible:
        assert known(a).dimension == known(b).dimension
        way, stated = known(a).from_si.inverse.then(known(b).from_si), between(a, b)
        assert stated is not None
        assert [float(way(x)) for x in (0, 1)] == pytest.approx([float(stated(x)) for x in (0, 1)])


@pytest.mark.parametrize(
    ("unit", "dimension"),
    [
        ("V", Dimension(length=2, mass=1, time=-3, current=-1)),
        ("Ohm", Dimension(length=2, mass=1, time=-3, current=-2)),
        ("kPa", Dimension(length=-1, mass=1, time=-2)),
        ("lx", Dimension(length=-2, luminous_intensity=1)),
        ("degrees", Dimension()),
    ],
)
def test_dimensions_are_those_of_the_si(unit, dimension):
    assert known(unit).dimension == dimension


@pytest.mark.parametrize("unit", ["", "knots", "nm", "MW h"])
def test_other_units_are_not_guessed(unit):
    assert si_unit(unit) is None


def test_a_unit_of_the_deployment_is_the_decimal_number_that_was_written():
    described = UnitSettings.model_validate({"factor": 1.1, "offset": -0.1, "length": 1, "time": -1})
    assert described.si.from_si == (Fraction(11, 10), Fraction(-1, 10))
    assert described.si.dimension == Dimension(length=1, time=-1)
