"""Signals that the catalogue does not have are defined from what the code says; near signals share a word or the unit."""

import pytest

from sigcat.cli import main
from tests.function.importing.linting import rules_found

HEADER = """\
#pragma once
typedef unsigned char boolean_T;
typedef enum { PUMP_OFF, PUMP_ON } pump_t;
extern boolean_T Flow;               /* '<Root>/Flow' Whether coolant flows */
extern float CoolTemp[2];            /* '<Root>/CoolTemp' [degC] [-40,150] temperature of the coolant */
extern short Level;                  /* '<Root>/Level' level of the tank, fixdt(1,16,0.5,0) */
extern pump_t Wanted;                /* '<Root>/Wanted' */
extern int id;                       /* '<Root>/id' */
extern float VehSpd;                 /* '<Root>/VehSpd' [km/h] */
extern float Duty;                   /* '<S1>/Duty' [%] [0,100] */
void Pump_initialize(void);
void Pump_step(void);                /* Sample time: [0.0000625s, 0.0s] */
"""
SOURCE = """\
#include "Pump.h"
float Duty;
void Pump_initialize(void) {}
void Pump_step(void) { Duty = Flow + CoolTemp[0] + Level + Wanted + id + VehSpd; }
"""


@pytest.fixture
def code(tmp_path):
    folder = tmp_path / "code"
    folder.mkdir()
    (folder / "Pump.h").write_text(HEADER)
    (folder / "Pump.c").write_text(SOURCE)
    return folder


def test_own_signals_are_defined_with_what_the_code_says(code, capsys):
    assert main(["function", "new", "Pump", "--from-c", str(code), "--define-under", "Vehicle.Cooling.Pump"]) == 0
    text = (code / "function.yaml").read_text()
    assert "TODO" not in text
    for each in (
        "Vehicle.Cooling:\n      type: branch\n",
        "Vehicle.Cooling.Pump.IsFlow:\n      datatype: boolean\n      asil: QM\n      description: Whether coolant flows.\n",
        "CoolTemp:\n      datatype: float[]\n      arraysize: 2\n      unit: Celsius\n      min: -40\n      max: 150\n",
        "description: Temperature of the coolant.\n",
        "Level:\n      datatype: double\n",
        "Wanted:\n      datatype: string\n      allowed: [PUMP_OFF, PUMP_ON]\n",
        "path: Vehicle.Speed\n",
        "cycleTime: 0.0625\n",
    ):
        assert each in text
    assert rules_found(code / "function.yaml") <= {"F103"}, "providers of own signals are left to name"
    assert main(["simulate", str(code / "function.yaml"), "--duration", "0.001"]) == 0
    assert "0.000062500,Pump_Step" in capsys.readouterr().out


@pytest.mark.parametrize("branch", ["Pump", "Vehicle", "Vehicle.Speed", "Vehicle.a-b", "Car.Pump"])
def test_what_is_no_branch_is_refused_and_nothing_written(branch, code, capsys):
    assert main(["function", "new", "Pump", "--from-c", str(code), "--define-under", branch]) == 2
    assert "--define-under must be" in capsys.readouterr().err
    assert not (code / "function.yaml").exists()


def test_short_names_have_no_near_signals(code):
    main(["function", "new", "Pump", "--from-c", str(code)])
    lines = (code / "function.yaml").read_text().splitlines()
    at = lines.index("          - path: Vehicle.TODO.id")
    assert "Near" not in lines[at - 1]
