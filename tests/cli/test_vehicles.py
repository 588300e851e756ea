"""Vehicles on the command line: lists, differences, functions that are checked against them."""

import csv
import json
import subprocess
from io import StringIO
from pathlib import Path

import pytest

from sigcat.cli import main
from tests.cli.test_completion import completed

PROJECT = """\
[[catalogue]]
id = "std"
release = "shipped"

[[vehicle]]
id = "coupe"
attributes = {steering = "left"}
without = ["Vehicle.Cabin.Sunroof"]

[[vehicle.state]]
id = "sop"

[[vehicle.state]]
id = "ota2"
without = []

[[vehicle]]
id = "truck"
instances = {Vehicle.Chassis.Axle = 3}
"""
FUNCTION = """\
function: Roof
description: Closes the sunroof.
responsible: Body team
define:
  scheduling:
    Init: {asil: QM, description: Clears the state.}
    Step: {cycleTime: 100, asil: QM, description: Closes the sunroof.}
    Terminate: {asil: QM, description: Releases resources.}
components:
  - name: Roof
    runnables:
      - interface: Roof_Init
      - interface: Roof_Step
        data:
          - {path: Vehicle.Speed, role: consumed}
          - {path: Vehicle.Cabin.Sunroof.Switch, role: provided}
      - interface: Roof_Terminate
"""


@pytest.mark.parametrize("pattern", ["Vehicle.Own", "Vehicle.Own*"])
def test_a_branch_that_an_overlay_does_not_define_is_the_only_error(tmp_path, capsys, pattern):
    project = PROJECT.replace('release = "shipped"', 'release = "shipped"\noverlays = ["own.vspec"]')
    (tmp_path / "sigcat.toml").write_text(project.replace("Vehicle.Cabin.Sunroof", pattern))
    overlay = "Vehicle.Own.Thing: {type: sensor, datatype: float, description: A thing.}\n"
    (tmp_path / "own.vspec").write_text(overlay)
    for command in (["lint", "own.vspec"], ["vehicles"], ["show", "-s", "vehicle:coupe", "Vehicle.Speed"]):
        assert main(command) == 1
        captured = capsys.readouterr()
        assert "V020 Branch 'Vehicle.Own' is not defined" in captured.out + captured.err
        assert "internal error" not in captured.err


@pytest.fixture(autouse=True)
def folder(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "sigcat.toml").write_text(PROJECT)
    (tmp_path / "function.yaml").write_text(FUNCTION)
    return tmp_path


def output(capsys, *arguments, status=0):
    assert main([*arguments]) == status
    return capsys.readouterr().out


def test_the_list_has_each_state_with_its_facts(capsys):
    listed = json.loads(output(capsys, "vehicles", "--format", "json"))
    assert [each["name"] for each in listed] == ["coupe@sop", "coupe@ota2", "truck"]
    assert listed[1]["signals"] - listed[0]["signals"] == 5
    assert listed[0]["attributes"] == {"steering": "left"}
    assert "steering: left" in output(capsys, "vehicles", "--vehicles", "coupe@sop")
    assert output(capsys, "vehicles", "--format", "csv").startswith(
        "name,title,catalogue,signals,attributes\ncoupe@sop,"
    )


def test_the_matrix_has_the_uppermost_nodes_in_which_vehicles_differ(capsys):
    assert output(capsys, "vehicles", "--matrix") == (
        "Vehicle.Cabin.Sunroof.      coupe@ota2, truck\nVehicle.Chassis.Axle.Row3.  truck\n"
    )
    rows = list(csv.reader(StringIO(output(capsys, "vehicles", "--matrix", "--format", "csv", "roof"))))
    header = ["path", "type", "signals", "coupe@sop", "coupe@ota2", "truck"]
    assert rows == [header, ["Vehicle.Cabin.Sunroof", "branch", "5", "0", "1", "1"]]
    (row,) = json.loads(output(capsys, "vehicles", "--matrix", "--format", "json", "--vehicles", "coupe"))
    assert row["vehicles"] == ["coupe@ota2"]
    assert "Vehicle.Speed  " in output(capsys, "vehicles", "--matrix", "--all", "speed")


def test_vehicles_that_do_not_differ_have_no_rows(capsys, folder):
    (folder / "sigcat.toml").write_text('[[vehicle]]\nid = "a"\n[[vehicle]]\nid = "b"\n')
    assert main(["vehicles", "--matrix"]) == 0
    assert capsys.readouterr() == ("", "The vehicles do not differ in any node. `--all` lists all nodes.\n")


def test_what_cannot_be_listed_is_refused(capsys, folder):
    assert main(["vehicles", "speed"]) == 2
    assert main(["vehicles", "--vehicles", "coup"]) == 2
    assert "Did you mean coupe?" in capsys.readouterr().err
    (folder / "sigcat.toml").write_text(PROJECT.replace("Sunroof", "Sunrof"))
    assert main(["vehicles"]) == 1
    assert "sigcat.toml:8:13: error C007" in capsys.readouterr().err
    (folder / "sigcat.toml").write_text("")
    assert main(["vehicles"]) == 2
    assert "Add a [[vehicle]]" in capsys.readouterr().err


def test_two_vehicles_or_states_are_compared(capsys):
    states = json.loads(output(capsys, "diff", "vehicle:coupe@sop", "vehicle:coupe@ota2", "--format", "json"))
    assert {change["kind"] for change in states["changes"]} == {"added"}
    vehicles = output(capsys, "diff", "vehicle:coupe@sop", "vehicle:truck")
    assert "Sunroof" in vehicles
    assert "Axle" in vehicles
    assert main(["diff", "vehicle:coup", "vehicle:truck"]) == 2
    assert "Unknown vehicle 'coup'" in capsys.readouterr().err


def test_a_vehicle_of_a_revision_is_compared_with_the_present_one(capsys, folder):
    git = ["git", "-c", "user.name=A", "-c", "user.email=a@example.com"]
    for arguments in (["init", "-q"], ["add", "."], ["commit", "-q", "-m", "first"]):
        subprocess.run([*git, *arguments], check=True, cwd=folder)
    (folder / "sigcat.toml").write_text(PROJECT.replace("without = []", 'without = ["Vehicle.ADAS"]'))
    assert "ADAS" in output(capsys, "diff", "git:HEAD:vehicle:coupe", "vehicle:coupe")
    assert "ADAS" not in output(capsys, "diff", "git:HEAD:vehicle:truck", "vehicle:truck")


@pytest.mark.parametrize(
    "command",
    [
        ["show", "Vehicle.Cabin.Sunroof", "--format", "json"],
        ["search", "sunroof"],
        ["units", "km"],
        ["export", "csv"],
        ["function", "build", "function.yaml"],
    ],
)
def test_each_command_that_takes_a_tree_takes_a_vehicle(command, capsys):
    assert main([*command, "-s", "vehicle:coupe"]) == 0
    assert main([*command, "-s", "vehicle:cope"]) == 2
    assert "Did you mean vehicle:coupe" in capsys.readouterr().err


def test_a_function_is_checked_against_each_vehicle(capsys):
    assert main(["function", "validate", "function.yaml"]) == 0
    capsys.readouterr()
    found = json.loads(
        output(capsys, "function", "validate", "--vehicles", "all", "--format", "json", "function.yaml", status=1)
    )
    (finding,) = found["findings"]
    assert (finding["rule"], finding["file"], finding["line"]) == ("F010", "function.yaml", 16)
    assert finding["message"] == (
        "Vehicle 'coupe@sop' has no 'Vehicle.Cabin.Sunroof.Switch', which Roof_Step provides."
    )
    assert main(["function", "validate", "--vehicles", "truck,coupe@ota2", "function.yaml"]) == 0
    assert main(["function", "validate", "--vehicles", "trck", "function.yaml"]) == 2


def test_a_signal_that_is_different_in_a_vehicle_is_a_finding_there(capsys, folder):
    (folder / "changed.vspec").write_text("Vehicle.Speed: {type: sensor, datatype: float, min: 50, unit: km/h}\n")
    (folder / "sigcat.toml").write_text(PROJECT + 'with = ["changed.vspec"]\n')
    text = FUNCTION.replace("{path: Vehicle.Speed, role: consumed}", "{path: Vehicle.Speed, role: consumed, init: 3}")
    (folder / "function.yaml").write_text(text)
    assert main(["function", "validate", "--vehicles", "coupe@ota2", "function.yaml"]) == 0
    assert main(["function", "validate", "--vehicles", "truck", "function.yaml"]) == 1
    assert "In vehicle 'truck': " in capsys.readouterr().out


def test_a_vehicle_with_errors_is_not_checked(capsys, folder):
    (folder / "sigcat.toml").write_text(PROJECT.replace("Vehicle.Chassis.Axle", "Vehicle.Chassis.Axl"))
    assert main(["function", "validate", "--vehicles", "truck", "function.yaml"]) == 1
    assert "vehicle:truck has errors; no function was checked in it" in capsys.readouterr().err


def test_a_lint_of_the_project_checks_its_vehicles(capsys, folder):
    assert main(["lint"]) == 0
    (folder / "sigcat.toml").write_text(PROJECT.replace("Vehicle.Chassis.Axle", "Vehicle.Chassis.Axl"))
    for paths in ([], ["."], ["sigcat.toml"]):
        capsys.readouterr()
        assert main(["lint", *paths]) == 1
        assert (
            "sigcat.toml:19:1: error C007 Catalogue 'std' has no node 'Vehicle.Chassis.Axl'" in capsys.readouterr().out
        )
        assert main(["lint", "--format", "json", *paths]) == 1
        assert [each["rule"] for each in json.loads(capsys.readouterr().out)["findings"]] == ["C007"]
    assert main(["lint", "function.yaml"]) == 0


def test_a_project_of_vehicles_alone_is_checked(capsys, folder):
    (folder / "function.yaml").unlink()
    assert main(["lint"]) == 0
    assert main(["lint", "sigcat.toml"]) == 0


def test_the_configuration_lists_the_vehicles(capsys):
    lines = output(capsys, "config", "--show")
    assert "vehicle = coupe@sop" in lines
    assert "  attributes.steering = left" in lines
    (row,) = (line for line in lines.splitlines() if line.startswith("  instances.Vehicle.Chassis.Axle = 3"))
    assert row.endswith("# sigcat.toml:19")


def test_ids_of_vehicles_are_completed():
    assert completed("sigcat show Vehicle.Speed -s vehicle:tr") in (["vehicle:truck"], ["truck"])
    assert completed("sigcat function validate --vehicles coupe@s") == ["coupe@sop"]


def test_the_schema_knows_the_project(capsys):
    import tomllib

    from jsonschema import Draft202012Validator

    validator = Draft202012Validator(json.loads(output(capsys, "schema", "project")))
    assert [*validator.iter_errors(tomllib.loads(Path("sigcat.toml").read_text()))] == []
    assert [*validator.iter_errors({"vehicle": [{"id": "v", "whithout": []}]})]
