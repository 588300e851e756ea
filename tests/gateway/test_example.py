"""The drive of EcoControl comes from CAN as it is in drive.csv, so that everything that is played from either is the same."""

import csv
from collections import Counter
from pathlib import Path

import pytest

from sigcat.cli import main

EXAMPLE = Path(__file__).parents[2] / "examples/ecocontrol"
ALTITUDE = "Vehicle.ADAS.Map.Horizon.Altitude"


@pytest.fixture(scope="module")
def trace(tmp_path_factory):
    """The trace of the log."""
    path = tmp_path_factory.mktemp("can") / "drive.csv"
    can = EXAMPLE / "can"
    given = ["gateway", can / "drive.log.gz", "--dbc", can / "ecocontrol.dbc", "-l", can / "can.vspec"]
    assert main([*map(str, given), "--add", str(EXAMPLE / "drive.csv"), "-o", str(path)]) == 0
    return path


def values(path):
    """When which value came, of every column."""
    with path.open(newline="") as file:
        return Counter(
            (row["time"], name, number(cell)) for row in csv.DictReader(file) for name, cell in row.items()
            if cell and name != "time"
        )  # fmt: skip


def number(cell):
    """The text of a number, in one form; any other cell as it is."""
    try:
        return str(float(cell))
    except ValueError:
        return cell


def test_every_value_comes_at_its_time(trace):
    assert values(trace) == values(EXAMPLE / "drive.csv")


def test_only_the_altitude_profile_does_not_come_from_can(trace):
    header = trace.read_text().partition("\n")[0].split(",")
    assert header[-1] == ALTITUDE
    assert ALTITUDE not in (EXAMPLE / "can/can.vspec").read_text()


def test_lint_finds_nothing_in_the_mappings(capsys):
    can = EXAMPLE / "can"
    assert main(["lint", str(can), "--dbc", str(can / "ecocontrol.dbc")]) == 0
    assert "M" not in capsys.readouterr().out
