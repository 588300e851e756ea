"""Parts of multiplexed messages: those that the frame selects are taken, also nested ones and those of several numbers."""

import csv
import random
from typing import Any

import can
import cantools
import pytest

from sigcat.cli import main

DBC = """\
VERSION ""
BU_: Gateway
BO_ 256 Pages: 8 Gateway
 SG_ Page M : 0|8@1+ (1,0) [0|0] "" Gateway
 SG_ Sub m1M : 8|8@1+ (1,0) [0|0] "" Gateway
 SG_ Deep m3 : 16|16@0+ (1,0) [0|0] "" Gateway
 SG_ Both m0 : 16|8@1- (1,0) [0|0] "" Gateway
 SG_ Common : 56|8@1+ (1,0) [0|0] "" Gateway
SG_MUL_VAL_ 256 Sub Page 1-1;
SG_MUL_VAL_ 256 Deep Sub 3-3;
SG_MUL_VAL_ 256 Both Page 0-0, 5-7;
"""
NAMES = ("Page", "Sub", "Deep", "Both", "Common")


@pytest.fixture
def rows(tmp_path):
    """The rows of a log of frames, by the names of signals."""

    def reading(frames):
        (tmp_path / "bus.dbc").write_text(DBC)
        mapped = "Vehicle.{0}: {{type: sensor, datatype: int32, description: A., dbc2vss: {{signal: {0}, interval_ms: 0}}}}\n"
        (tmp_path / "can.vspec").write_text("".join(mapped.format(name) for name in NAMES))
        with can.Logger(str(tmp_path / "drive.log")) as logger:
            for index, data in enumerate(frames):
                logger.on_message_received(
                    can.Message(timestamp=index, arbitration_id=256, is_extended_id=False, data=data)
                )
        out = tmp_path / "trace.csv"
        given = [tmp_path / "drive.log", "--dbc", tmp_path / "bus.dbc", "-s", "vss", "-l", tmp_path / "can.vspec"]
        assert main(["gateway", *map(str, given), "-o", str(out)]) == 0
        with out.open(newline="") as file:
            return [
                {name: int(row[f"Vehicle.{name}"]) for name in NAMES if row[f"Vehicle.{name}"]}
                for row in csv.DictReader(file)
            ]

    return reading


def test_parts_are_those_of_cantools(rows):
    chance = random.Random(11)
    numbers = [0, 1, 5, 6, 7]
    frames = [bytes([chance.choice(numbers), 3, *chance.randbytes(6)]) for _ in range(300)]
    database: Any = cantools.database.load_string(DBC, "dbc")
    message = database.messages[0]
    assert rows(frames) == [message.decode(data, scaling=False, decode_choices=False) for data in frames]


def test_of_an_undefined_part_the_rest_is_taken(rows):
    assert rows([bytes([1, 9, 0, 0, 0, 0, 0, 4]), bytes([9, 0, 0, 0, 0, 0, 0, 5])]) == [
        {"Page": 1, "Sub": 9, "Common": 4},
        {"Page": 9, "Common": 5},
    ]
