"""`sigcat units`: what there is, how it converts, and how to define what is missing."""

import json
from pathlib import Path

import pytest

from sigcat.cli import main
from tests.project.company import OVERLAY, write_company

OWN = "ppm:\n  definition: Parts per million.\n  unit: parts per million\n  quantity: relation\n  allowed-datatypes: ['numeric']\n"


def output(capsys, *words):
    assert main(["units", *words]) == 0
    return capsys.readouterr().out


def test_units_are_listed_by_quantity_with_their_factors(capsys):
    lines = output(capsys).splitlines()
    assert any(line.startswith("velocity: ") for line in lines)
    assert "  km/h         kilometer per hour               = 0.2777777777777778 (5/18) m/s" in lines
    assert (
        "  Fahrenheit   degree Fahrenheit                = 0.5555555555555556 (5/9) Celsius - 17.77777777777778 (160/9)"
        in lines
    )


@pytest.mark.parametrize("words", [["degC"], ["degree", "celsius"], ["hPa"], ["revolutions"]])
def test_units_are_found_by_key_name_and_other_spellings(capsys, words):
    assert len(output(capsys, *words).splitlines()) in (2, 3)


@pytest.mark.parametrize(
    ("given", "expected"),
    [
        (("100", "km/h", "m/s"), "100 km/h = 27.77777777777778 (250/9) m/s"),
        (("-40", "degC", "Fahrenheit"), "-40 Celsius = -40 Fahrenheit"),
        (("1", "bar", "kPa"), "1 bar = 100 kPa"),
        (("180", "degrees", "radians"), "180 degrees = 3.141592653589793 radians"),
    ],
)
def test_a_number_is_converted_exactly(capsys, given, expected):
    assert output(capsys, "convert", *given) == f"{expected}\n"


@pytest.mark.parametrize(
    ("given", "reason"),
    [
        (("1", "km", "s"), "km (length) cannot be converted to s (duration). km converts to mm, cm, m, inch."),
        (("x", "km", "m"), "'x' is not a number that a double holds: write one first"),
        (("1e400", "km", "m"), "'1e400' is not a number that a double holds"),
        (("1", "km"), "write a number and two units"),
        (("1", "kmm", "m"), "unknown unit 'kmm'. Did you mean"),
    ],
)
def test_what_cannot_be_converted_is_told_with_what_can(capsys, given, reason):
    assert main(["units", "convert", *given]) == 2
    assert reason in capsys.readouterr().err


def test_a_unit_that_is_missing_comes_with_its_definition(capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert main(["units", "ppm"]) == 2
    told = capsys.readouterr().err
    assert "`ppm: {definition: Parts per million., unit: parts per million, quantity: relation" in told
    Path("units.yaml").write_text(f"{told.split('`')[1]}\n")
    assert "parts per million" in output(capsys, "ppm", "-u", "units.yaml")


def test_json_has_factor_and_origin(capsys):
    (unit,) = json.loads(output(capsys, "kmh", "--format", "json"))
    assert (unit["key"], unit["base"], unit["factor"], unit["offset"]) == ("km/h", "m/s", 5 / 18, 0)


def test_units_are_listed_while_the_tree_has_errors(tmp_path, monkeypatch, capsys):
    write_company(tmp_path)
    monkeypatch.chdir(tmp_path)
    Path("overlays/acme.vspec").write_text(OVERLAY.replace("unit: ppm", "unit: pmm"))
    assert main(["units", "parts"]) == 0
    assert "parts per million" in capsys.readouterr().out
