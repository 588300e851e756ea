"""Allowed values that protoc refuses in the exported messages are reported, whatever else exports the tree."""

import pytest

from sigcat.catalogue.exporting.export import exported
from tests.catalogue.trees import ROOT, catalogue_of

SIGNAL = "Vehicle.{}: {{type: sensor, datatype: {}, allowed: [{}], description: Text.}}\n"
BRANCH = "Vehicle.Front: {type: branch, description: Front.}\n"
MODE, STATE = SIGNAL.format("Mode", "string", "UNKNOWN, ECO"), SIGNAL.format("State", "'string[]'", "OPEN, UNKNOWN")


def found(text, exporter="protobuf"):
    return [(each.rule, each.path, each.message) for each in exported(catalogue_of(ROOT + text), exporter).findings]


def test_a_value_of_two_signals_of_a_branch_is_reported():
    message = "protoc refuses the value 'UNKNOWN', which is also one of Vehicle.Mode."
    assert found(MODE + STATE) == [("X006", "Vehicle.State", message)]


@pytest.mark.parametrize("value", ["'1'", "A-B", "'2nd'", "''", "Ä"])
def test_a_value_that_is_no_name_is_reported(value):
    message = f"protoc refuses the value {value.strip(chr(39))!r}, which is not a name."
    assert found(SIGNAL.format("Mode", "string", value)) == [("X006", "Vehicle.Mode", message)]


def test_of_many_signals_the_first_is_reported_with_their_number():
    more = "".join(SIGNAL.format(f"S{number}", "string", "UNKNOWN") for number in range(1_500))
    (finding,) = found(MODE + more)
    assert finding[1] == "Vehicle.S0"
    assert finding[2].endswith(" The same is true of 1,499 more.")


@pytest.mark.parametrize(
    "text",
    [
        MODE,
        MODE + SIGNAL.format("State", "string", "OPEN, CLOSED"),
        MODE + BRANCH + SIGNAL.format("Front.State", "string", "UNKNOWN"),
        SIGNAL.format("Level", "uint8", "1, 2"),
    ],
)
def test_names_of_their_own_have_no_finding(text):
    assert not found(text)


def test_other_exports_have_no_such_message():
    assert not found(MODE + STATE, "csv")
