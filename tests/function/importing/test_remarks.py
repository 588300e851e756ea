"""Contents of a comment: port, unit, range, scale and cycle time, in the styles of code."""

import pytest

from sigcat.function.c_project.comments import Comments
from sigcat.function.c_project.remarks import Remark, cycle_time_of, remark_of
from sigcat.function.importing.units import unit_of
from tests.function.shipped import interfaces


@pytest.mark.parametrize(
    ("comment", "remark"),
    [
        ("'<Root>/EngSpd'", Remark(port="EngSpd")),
        ("'<Root>/b_hallA '", Remark(port="b_hallA")),
        ("'<S13>/Counter'", Remark()),
        ("Variable: Kp\nReferenced by: '<S2>/Kp'", Remark()),
        ("Expression: [0, 1]\nReferenced by:\n  '<S2>/a'\n  '<S3>/b'", Remark()),
        ("'<Root>/p'\nRaw value of rail pressure", Remark(port="p", text="Raw value of rail pressure")),
        ("Unit: km/h  Range: 0..250", Remark(units=("km/h",), min=0, max=250, unit="km/h")),
        ("Units: [1/min]", Remark(units=("1/min",), unit="1/min")),
        ("[0,100]", Remark(min=0, max=100)),
        ("[-1.5, 1e3]", Remark(min=-1.5, max=1000.0)),
        ("range -40 to 150", Remark(min=-40, max=150)),
        ("(0 .. 4)", Remark(min=0, max=4)),
        ("min: -5, max: 5", Remark(min=-5, max=5)),
        ("minimum 2", Remark(min=2)),
        ("'<Root>/ax' m/s^2", Remark("ax", ("m/s^2",))),
        ("Vehicle speed [km/h] [0,250]", Remark("", ("km/h",), 0, 250, text="Vehicle speed [km/h]", unit="km/h")),
        ("[K]", Remark(units=("K",), unit="K")),
        ("m/s, 0.0 to 100.0: speed", Remark(units=("m/s",), min=0.0, max=100.0, text="m/s, : speed")),
        ("kg: mass of the vehicle", Remark(units=("kg",), text="kg: mass of the vehicle")),
        ("longitudinal acceleration, m/s^2", Remark(units=("m/s^2",), text="longitudinal acceleration, m/s^2")),
        ("speed over ground km/h", Remark(units=("km/h",), text="speed over ground km/h")),
        ("from 2019-02-01 to 2020-01-01", Remark(text="from 2019-02-01 to 2020-01-01")),
        ("see chapter [3,4] of the manual", Remark(text="see chapter [3,4] of the manual")),
        ("Oil pressure of section 3 to 4, range 0 to 10", Remark(min=0, max=10, text="Oil pressure of section 3 to 4")),
        ("Range: 5..1", Remark()),
        ("(1, 2)", Remark()),
        ("sfix16_En8", Remark(factor=0.00390625)),
        ("ufix8_E2", Remark(factor=4)),
        ("fixdt(1,16,4)", Remark(factor=0.0625)),
        ("fixdt(0,16,0.01,-40)", Remark(factor=0.01, offset=-40)),
        ("fixdt(0,16,2^-3,0)", Remark(factor=0.125, offset=0)),
        ("scaling 2^-8", Remark(factor=0.00390625)),
        ("m/s 2^-8", Remark(units=("m/s",), factor=0.00390625)),
        ("speed in 2**(-4) km/h", Remark(units=("km/h",), factor=0.0625, text="speed in km/h")),
        ("LSB = 1/256", Remark(factor=0.00390625)),
        ("slope 0.1, bias -40", Remark(factor=0.1, offset=-40)),
        ("factor: 2^-200", Remark(factor=1)),
        ("scale 1/0", Remark(factor=1)),
        ("", Remark()),
        ("*" * 5_000, Remark()),
        ("[" * 5_000, Remark()),
        ("1" * 5_000, Remark()),
    ],
)
def test_a_comment_says(comment, remark):
    assert remark_of(comment) == remark


@pytest.mark.parametrize("comment", ["min: 5", "factor 2^-3", "note: none", "[0,100]", "1: on, 2: off", "7 of 9"])
def test_what_is_no_unit_is_not_taken_for_one(comment):
    assert unit_of(remark_of(comment).units, interfaces().vocabulary) == ""


@pytest.mark.parametrize(
    ("comment", "milliseconds"),
    [
        ("Sample time: [0.0005s, 0.0s]", 0.5),
        ("Sample time: [0.02s, 0.0s]", 20),
        ("Step: 0.05 s", 50),
        ("called every 10 ms", 10),
        ("cycle time 20ms", 20),
        ("Cycle: 500 us", 0.5),
        ("Sample time: [-1s, 0.0s]", None),
        ("Sample time: [0.0s, 0.0s]", None),
        ("every 0 ms", None),
        ("every 5 minutes", None),
        ("Model step function", None),
    ],
)
def test_a_comment_says_how_often_a_call_is_made(comment, milliseconds):
    assert cycle_time_of(comment) == milliseconds


@pytest.mark.parametrize(
    ("text", "key"),
    [("kph", "km/h"), ("KM/H", "km/h"), ("m/s2", "m/s^2"), ("%", "percent"), ("degC", "Celsius"), ("°", "degrees"),
     ("U/min", "rpm"), ("N.m", "Nm"), ("-", ""), ("furlong", ""), ("", "")],
)  # fmt: skip
def test_a_unit_is_spelled_in_many_ways(text, key):
    assert unit_of([text], interfaces().vocabulary) == key


@pytest.mark.parametrize(
    ("line", "found"),
    [
        ("float flow; /* [l/h] */ int speed; /* [rpm] */ bool dry;", {"flow": "[l/h]", "speed": "[rpm]", "dry": ""}),
        ("float flow; int speed; int temp[4]; /* [degC] */", {"flow": "", "speed": "", "temp": "[degC]"}),
        ("float near, far; /* [m] */", {"near": "[m]", "far": "[m]"}),
        ("unsigned is_dry : 1; /* dry */ unsigned is_on : 1; /* on */", {"is_dry": "dry", "is_on": "on"}),
        ("extern DW model; /* states */", {"of_another_line": "states"}),
    ],
)
def test_a_comment_belongs_to_the_name_before_it(line, found):
    comments = Comments(line)
    assert {name: comments.beside(1, name) for name in found} == found
