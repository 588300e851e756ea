"""Units that the code names and the catalogue does not have: nothing is assumed."""

import pytest

from sigcat.cli import main

CODE = """\
#pragma once
extern float AmbientAirTemperature; /* {} */
extern float Duty;
void p_init(void);
void p_step(void);
"""
SOURCE = """\
#include "p.h"
float AmbientAirTemperature, Duty;
void p_init(void) {}
void p_step(void) { Duty = AmbientAirTemperature; }
"""


@pytest.fixture
def imported(tmp_path):
    def make(comment, *options):
        (tmp_path / "p.h").write_text(CODE.format(comment))
        (tmp_path / "p.c").write_text(SOURCE)
        assert main(["function", "new", "P", "--from-c", str(tmp_path), *options]) == 0
        return tmp_path / "function.yaml"

    return make


@pytest.mark.parametrize("comment", ["[K]", "Unit: K", "temperature of the air [K] [200,400]"])
def test_no_unit_is_assumed(comment, imported, capsys):
    text = imported(comment).read_text()
    assert "path: Vehicle.TODO.AmbientAirTemperature" in text
    assert "TODO: the code says K, which is not a unit of the catalogue." in text
    assert "The code tells no unit" not in text
    assert "convert the values: K." in capsys.readouterr().err


def test_a_unit_that_is_known_is_taken(imported):
    text = imported("[degC]").read_text()
    assert "path: Vehicle.Cabin.HVAC.AmbientAirTemperature" in text
    assert "unit: Celsius" in text
    assert "TODO: the code" not in text


def test_a_signal_that_is_defined_has_no_unit_that_the_catalogue_lacks(imported, capsys):
    text = imported("[K]", "--define-under", "Vehicle.P").read_text()
    assert "unit:" not in text
    assert "TODO: the code says K" in text


def test_units_that_are_suggested_are_spelled_as_their_keys(imported, capsys):
    file = imported("[degC]")
    for unit in ("bar", "Kelvins"):
        file.write_text(file.read_text().replace("unit: Celsius", f"unit: {unit}"))
        capsys.readouterr()
        assert main(["lint", str(file)]) == 1
        assert "'Celsius' or one that it converts to: Fahrenheit." in capsys.readouterr().out
        file.write_text(file.read_text().replace(f"unit: {unit}", "unit: Celsius"))
