"""The value that a database calls «signal not available» is never a number: without a list, with a formula, with a representation."""

import csv
import struct

import can
import pytest

from sigcat.cli import main

DBC = """\
VERSION ""
BU_: Gateway
BO_ 256 Motion: 2 Gateway
 SG_ Speed : 0|16@1+ (0.01,0) [0|300] "km/h" Gateway
VAL_ 256 Speed 65535 "SNA" ;
"""
NAMED = "named by the database, and not a number for `math`"
WORD = "words where a number belongs"
OUTSIDE = "outside of the limits that the database states"


@pytest.fixture
def run(tmp_path, capsys):
    """The values of 36 km/h and of no value, and what is reported."""

    def running(mapping, datatype):
        (tmp_path / "bus.dbc").write_text(DBC)
        (tmp_path / "can.vspec").write_text(f"Vehicle.A: {{type: sensor, datatype: {datatype}, {mapping}}}\n")
        out, log = tmp_path / "trace.csv", tmp_path / "drive.log"
        with can.Logger(str(log)) as logger:
            for index, raw in enumerate((3600, 65535)):
                data = struct.pack("<H", raw)
                logger.on_message_received(
                    can.Message(timestamp=index, arbitration_id=256, is_extended_id=False, data=data)
                )
        given = [log, "--dbc", tmp_path / "bus.dbc", "-s", "vss", "-l", tmp_path / "can.vspec", "-o", out]
        assert main(["gateway", *map(str, given)]) == 0
        with out.open(newline="") as file:
            return [row["Vehicle.A"] for row in csv.DictReader(file)], capsys.readouterr().err

    return running


@pytest.mark.parametrize("attribute", ["dbc2vss", "network_serialization"])
@pytest.mark.parametrize(
    ("transform", "value", "why"), [("", "36.0", OUTSIDE), (", transform: {math: x/3.6}", "10.0", NAMED)]
)
def test_a_named_number_is_left_out(run, attribute, transform, value, why):
    values, told = run(f"{attribute}: {{signal: Speed{transform}}}", "double")
    assert [values, why in told] == [[value], True]


def test_a_marker_of_a_representation_stays_one(run):
    representation = "transform: {representation: [{value: 65535, text: SNA}]}"
    values, told = run(f"network_serialization: {{signal: Speed, {representation}}}", "double")
    assert [values, WORD in told] == [["36.0"], True]


def test_a_list_still_gives_a_named_number_its_value(run):
    values, _ = run("dbc2vss: {signal: Speed, transform: {mapping: [{from: SNA, to: -1}, {from: 36, to: 1}]}}", "int8")
    assert values == ["1", "-1"]
