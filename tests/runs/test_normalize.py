"""A trace becomes a normalized trace: one spelling of each value, and every error a finding."""

from pathlib import Path

import pytest

from sigcat.adapter.host.shapes import ERROR_CODE, Array, Number, Record
from sigcat.cli import main
from sigcat.runs.recording.cells import plain_text, value_of
from tests.adapter.autosar_adaptive.application.generated import FULL

GEAR = Number("uint8", (("P", 0), ("LOW, D", 2)))
OBJECTS = Path(__file__).with_name("cases") / "structs_and_queues/function.yaml"


@pytest.mark.parametrize(
    ("text", "shape", "plain"),
    [
        ("1", Number("boolean"), "true"),
        (" FALSE", Number("boolean"), "false"),
        ("3.0", Number("int16"), "3"),
        ("+7", Number("uint8"), "7"),
        ("18446744073709551615", Number("uint64"), "18446744073709551615"),
        ("0.10", Number("float"), "0.1"),
        ("1.000000059604644775390625", Number("float"), "1.0"),
        ("1.00000005960464477540", Number("float"), "1.0000001"),
        ("1e300", Number("double"), "1e+300"),
        ("-0", Number("float"), "-0.0"),
        ("NaN", Number("float"), "nan"),
        ("-Infinity", Number("double"), "-inf"),
        ("LOW, D", GEAR, "LOW, D"),
        ("2", GEAR, "LOW, D"),
        ("9", GEAR, "9"),
        ("[1, 2.50]", Array(Number("float"), 2), "1.0;2.5"),
        ('["P", 2]', Array(GEAR, 2), "P;LOW, D"),
        ('{"b": [3], "a": 1}', Record((("a", Number("boolean")), ("b", Array(Number("int8"), 1)))), "true;3"),
        ("0x33", ERROR_CODE, "51"),
        ("255", ERROR_CODE, "255"),
    ],
)
def test_a_value_has_one_spelling(text, shape, plain):
    assert plain_text(value_of(text, shape), shape) == plain


@pytest.fixture
def normalized(tmp_path, capsys):
    """The lines of a trace, and what is reported."""

    def running(text, status=0, function=OBJECTS):
        (tmp_path / "trace.csv").write_text(text)
        out = tmp_path / "normalized.tsv"
        options = ("--trace", tmp_path / "trace.csv", "-o", out)
        assert main(["normalize", str(function), *map(str, options)]) == status
        lines = out.read_text().splitlines() if out.exists() else []
        return lines, capsys.readouterr().err.replace(f"{tmp_path}/", "")

    return running


def test_times_are_in_ns_and_structs_in_the_order_of_their_declaration(normalized):
    lines, told = normalized(
        "time,call,Vehicle.Objects.Ahead,Vehicle.Objects.Lanes\n"
        '0.1,,"{""Speed"": 20, ""Kind"": ""TRUCK"", ""Position"": {""Y"": 2, ""X"": 1}}",\n'
        '0.100,Objects_Step,,"[1, ""NONE""]"\n'
        "2,,,\n"
    )
    assert lines == [
        "time_ns\tVehicle.Objects.Ahead\tVehicle.Objects.Lanes",
        "100000000\tTRUCK;20;1.0;2.0\t",
        "100000000\t\tSOLID;NONE",
        "2000000000\t\t",
    ]
    assert "no column for Vehicle.Objects.Around" in told


def test_the_path_of_a_mode_becomes_its_name_and_durations_are_left_out(normalized):
    lines, _ = normalized("time,Full_Step,Vehicle.Function.Full.Mode.In\n0,0.001,ON\n", function=FULL / "function.yaml")
    assert lines == ["time_ns\tFull_Mode_In", "0\tON"]


def test_the_column_of_a_code_is_before_that_of_its_values(normalized):
    name = "Vehicle.Objects.Lanes"
    lines, _ = normalized(f'time,{name},{name}:e2e\n0,"[0, 1]",0x33\n')
    assert lines == [f"time_ns\t{name}:e2e\t{name}", "0\t51\tNONE;SOLID"]


def test_a_code_needs_no_values(normalized):
    lines, _ = normalized("time,Vehicle.Objects.Lanes:e2e\n0,255\n")
    assert lines == ["time_ns\tVehicle.Objects.Lanes:e2e\tVehicle.Objects.Lanes", "0\t255\t"]


@pytest.mark.parametrize("code", ["bad", "-1", "256", "0x", "0x100"])
def test_a_code_that_is_none_is_a_finding_at_its_place(normalized, code):
    lines, told = normalized(f"time,Vehicle.Objects.Lanes:e2e\n0,{code}\n", status=1)
    assert (lines, "trace.csv:2:3: error " in told) == ([], True)
    assert "must be a code from 0 to 255, such as 0x33" in told


def test_all_errors_are_findings_and_nothing_is_written(normalized):
    lines, told = normalized('time,Vehicle.Objects.Lanes\n0,"[0, 7.5]"\n1,[0]\n0.5,\n', status=1)
    assert lines == []
    assert [line.split(": ")[0] for line in told.splitlines() if ": error" in line] == [
        "trace.csv:2:3", "trace.csv:3:3", "trace.csv:4:1",
    ]  # fmt: skip
