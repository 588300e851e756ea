"""The command line: what is printed, where it goes, and the exit status."""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

import pytest

from scripts.command_line import command_parsers
from sigcat.cli import main
from tests.catalogue.trees import ROOT
from tests.migration.chained_releases import chained_sources

SPEED = "Vehicle.Speed:\n  type: sensor\n  datatype: float\n  description: Speed.\n"


@pytest.fixture
def tree(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    file = tmp_path / "tree.vspec"
    file.write_text(ROOT + SPEED)
    return file


def sigcat(*arguments: str, folder: Path | None = None) -> subprocess.CompletedProcess[str]:
    """Run the command as a separate process."""
    return subprocess.run(
        [sys.executable, "-m", "sigcat.cli", *arguments],
        capture_output=True,
        text=True,
        cwd=folder,
        env={**os.environ, "PYTHONPATH": str(Path(__file__).parents[2] / "app")},
        check=False,
    )


def test_a_node_can_be_shown_as_the_json_of_the_api(tree, capsys):
    assert main(["show", "Vehicle.Speed", "-s", "tree.vspec", "--format", "json"]) == 0
    node = json.loads(capsys.readouterr().out)
    assert [node["path"], node["parent"], node["origin"]["line"]] == ["Vehicle.Speed", "Vehicle", 4]


def test_a_description_does_not_control_the_terminal(tree, capsys):
    tree.write_text(ROOT + SPEED.replace("Speed.\n", r'"\e[31mRed\a \u202e\nand more."' + "\n"))
    assert main(["show", "Vehicle.Speed", "-s", "tree.vspec"]) == 0
    assert r"\x1b[31mRed\x07 \u202e\nand more." in capsys.readouterr().out


def test_python_runs_the_command_as_a_module(tree):
    environment = {**os.environ, "PYTHONPATH": str(Path(__file__).parents[2] / "app")}
    command = [sys.executable, "-m", "sigcat", "show", "Vehicle.Speed", "-s", "tree.vspec"]
    assert subprocess.run(command, cwd=tree.parent, env=environment, check=False, capture_output=True).returncode == 0


@pytest.mark.parametrize("port", ["99999", "-1", "http", "²"])
def test_a_port_is_a_number_of_tcp(capsys, port):
    with pytest.raises(SystemExit):
        main(["serve", f"--port={port}"])
    assert f"argument --port: must be a port from 0 to 65535, not {port!r}" in capsys.readouterr().err


@pytest.mark.parametrize("asked", ["Vehicle.Sped", "vehicle.speed", "speed", "Sped", "how fast"])
def test_a_path_that_does_not_exist_is_answered_with_what_may_have_been_meant(tree, asked, capsys):
    tree.write_text(ROOT + SPEED.replace("Speed.\n", "How fast it drives.\n"))
    assert main(["show", asked, "-s", "tree.vspec"]) == 2
    assert "Did you mean Vehicle.Speed?" in capsys.readouterr().err


@pytest.mark.parametrize("asked", ["CO2x", "xyz", "Foo.Bar"])
def test_a_path_that_is_not_near_has_no_proposal(asked, capsys):
    assert main(["show", asked]) == 2
    assert capsys.readouterr().err == f"sigcat: unknown node {asked!r}.\n"


def test_a_definition_is_shown_with_its_instances(capsys):
    assert main(["show", "Vehicle.Cabin.Door.IsOpen"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "Vehicle.Cabin.Door.IsOpen"
    assert "  4 instances    Vehicle.Cabin.Door.Row1.DriverSide.IsOpen" in lines
    assert lines[-1].split() == ["Vehicle.Cabin.Door.Row2.PassengerSide.IsOpen"]
    assert main(["show", "Vehicle.Cabin.Door.IsOpen", "--format", "json"]) == 0
    assert json.loads(capsys.readouterr().out)["parent"] == "Vehicle.Cabin.Door"


def test_a_mistyped_path_of_a_definition_proposes_it(capsys):
    assert main(["show", "Vehicle.Cabin.Door.IsOpn"]) == 2
    assert "Did you mean Vehicle.Cabin.Door.IsOpen" in capsys.readouterr().err


def test_a_path_may_have_slashes(tree, capsys):
    assert main(["show", "Vehicle/Speed", "-s", "tree.vspec"]) == 0
    assert capsys.readouterr().out.startswith("Vehicle.Speed\n")


def test_search_prints_a_node_in_each_line_for_pipes(capsys):
    assert main(["search", "wheel", "speed", "--type", "sensor", "--limit", "2"]) == 0
    output = capsys.readouterr()
    assert output.out.splitlines()[0] == "Vehicle.Chassis.Axle.Row1.Wheel.Left.Speed  sensor float km/h  ×4"
    assert len(output.out.splitlines()) == 2
    assert "2 of " in output.err
    assert main(["search", "wheel", "speed", "--limit", "2", "--format", "json"]) == 0
    assert next(hit["instance_count"] for hit in json.loads(capsys.readouterr().out)) == 4
    assert main(["search", "wheel", "speed", "--limit", "2", "--instances"]) == 0
    assert capsys.readouterr().out.splitlines()[1] == "Vehicle.Chassis.Axle.Row1.Wheel.Right.Speed  sensor float km/h"


def test_a_search_without_results_fails_and_says_what_may_have_been_meant(tree, capsys):
    assert main(["search", "Sped", "-s", "tree.vspec"]) == 1
    output = capsys.readouterr()
    assert (output.out, output.err) == ("", "sigcat: no node has this word. Did you mean 'speed'?\n")


def test_a_search_for_a_type_that_there_is_not_says_which_there_are(tree, capsys):
    assert main(["search", "speed", "--type", "sensr", "-s", "tree.vspec"]) == 2
    error = capsys.readouterr().err
    assert "branch, sensor, actuator" in error
    assert error.endswith("Did you mean 'sensor'?\n")


def test_a_unit_that_allows_no_datatype_is_told_to_be_mended_in_its_file(tree, capsys):
    tree.write_text(ROOT + SPEED + "  unit: m\n")
    Path("units.yaml").write_text("m: {definition: Metre, unit: metre, quantity: length, allowed_datatypes: [float]}\n")
    Path("quantities.yaml").write_text("length: {definition: How long.}\n")
    assert main(["show", "Vehicle.Speed", "-s", "tree.vspec"]) == 1
    assert "it allows no datatype. Give 'm' its `allowed-datatypes` in the units file." in capsys.readouterr().err


def test_export_goes_to_standard_output(tree, capsys):
    assert main(["export", "json", "-s", "tree.vspec"]) == 0
    assert json.loads(capsys.readouterr().out)["Vehicle"]["children"]["Speed"]["datatype"] == "float"


def test_export_goes_to_a_file(tree):
    assert main(["export", "json", "-s", "tree.vspec", "-o", "out.json"]) == 0
    assert "Speed" in json.loads(Path("out.json").read_text())["Vehicle"]["children"]


def test_a_tree_with_errors_is_not_exported_and_the_old_file_stays(tree, capsys):
    Path("out.json").write_text("before")
    tree.write_text(ROOT + SPEED.replace("float", "flaot"))
    assert main(["export", "json", "-s", "tree.vspec", "-o", "out.json"]) == 1
    assert Path("out.json").read_text() == "before"
    assert "tree.vspec:6:13: error V003 'flaot' is not a datatype. Did you mean 'float'?" in capsys.readouterr().err


def test_without_a_tree_the_shipped_one_is_meant(capsys):
    assert main(["export", "json"]) == 0
    assert "Chassis" in json.loads(capsys.readouterr().out)["Vehicle"]["children"]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["export", "json", "-s", "none.vspec"], "none.vspec: there is no such file"),
        (
            ["export", "json", "-s", "tree.vspec", "-o", "tree.vspec/folder/tree.json"],
            "tree.vspec must be a folder, not a file",
        ),
        (["export", "json", "-s", "tree.vspec", "-o", "."], "must be a file, not a folder"),
        (["export", "json", "-s", "tree.vspec", "-e", "min"], "name one attribute that VSS does not define"),
        (["show", "Vehicle.Sped", "-s", "tree.vspec"], "Did you mean Vehicle.Speed?"),
    ],
)
def test_what_cannot_be_done_is_one_line_and_status_2(arguments, message, tree, capsys):
    assert main(arguments) == 2
    error = capsys.readouterr().err
    assert message in error
    assert error.count("\n") == 1


def test_struct_types_can_have_a_file_of_their_own(monkeypatch, tmp_path):
    monkeypatch.chdir(Path(__file__).parents[1] / "catalogue" / "cases" / "struct_types")
    types = tmp_path / "types.json"
    tree = tmp_path / "tree.json"
    assert (
        main(["export", "json", "-s", "tree.vspec", "-t", "types.vspec", "--types-output", str(types), "-o", str(tree)])
        == 0
    )
    assert "Geo" in json.loads(types.read_text())["Types"]["children"]
    assert "ComplexDataTypes" not in json.loads(tree.read_text())


def test_show_prints_every_attribute_with_its_origin(tree, capsys):
    Path("overlay.vspec").write_text("Vehicle.Speed:\n  datatype: double\n")
    assert main(["show", "Vehicle.Speed", "-s", "tree.vspec", "-l", "overlay.vspec"]) == 0
    output = capsys.readouterr().out
    assert "double  [overlay.vspec:2]" in output
    assert "was float  [tree.vspec:6]" in output


def test_a_reader_that_goes_away_is_no_error():
    process = subprocess.Popen(
        [sys.executable, "-m", "sigcat.cli", "export", "json"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        cwd=Path(__file__).parents[2],
    )
    assert process.stdout is not None
    process.stdout.read(1)
    process.stdout.close()
    assert process.stderr is not None
    assert process.stderr.read() == b""
    assert process.wait() == 0


def test_help_names_every_command():
    result = sigcat("--help")
    assert result.returncode == 0
    for command in ("lint", "export", "function", "rule", "show", "serve"):
        assert f"  {command}" in result.stdout


@pytest.mark.parametrize("parser", command_parsers(), ids=lambda parser: parser.prog)
def test_no_help_shows_a_word_of_python(parser):
    assert re.findall(r"\b(?:None|True|False|PosixPath|==SUPPRESS==)\b", parser.format_help()) == []


@pytest.mark.parametrize("command", ["lint", "export", "function", "rule", "show", "serve"])
def test_every_command_explains_itself(command):
    result = sigcat(command, "--help")
    assert result.returncode == 0
    assert "usage: sigcat" in result.stdout


def test_what_vss_tools_exports_is_exported_and_its_errors_reported_unless_the_export_is_strict(
    tmp_path, monkeypatch, capsys
):
    monkeypatch.chdir(tmp_path)
    Path("twice.vspec").write_text("Vehicle.Speed:\n  comment: One.\n  comment: Two.\n")
    arguments = ["export", "json", "-l", "twice.vspec", "-o", "tree.json"]
    assert main([*arguments, "--strict"]) == 1
    assert main(["export", "ros2interface", "-l", "twice.vspec", "-o", "tree.json", "--strict"]) == 1
    assert not Path("tree.json").exists()
    assert main(arguments) == 0
    assert "twice.vspec:3:3: error R006" in capsys.readouterr().err
    assert json.loads(Path("tree.json").read_text())["Vehicle"]["children"]["Speed"]["comment"] == "Two."


def test_an_overlay_that_cannot_be_read_does_not_differ_from_nothing(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    Path("broken.vspec").write_text("Vehicle.Speed: {comment: [}\n")
    assert main(["try", "broken.vspec"]) == 1
    assert "No differences" not in capsys.readouterr().out


@pytest.mark.parametrize(
    ("path", "code", "message"),
    [("Car.Rpm", 0, ""), ("Train.Rpm", 1, "'Train.Rpm' is outside of the tree, whose root is 'Car'")],
)
def test_lint_and_export_take_the_tree_near_an_overlay(tmp_path, path, code, message):
    (tmp_path / "vspec").mkdir()
    (tmp_path / "vspec/VehicleSignalSpecification.vspec").write_text("Car:\n  type: branch\n  description: A car.\n")
    overlay = tmp_path / "rpm.vspec"
    overlay.write_text(f"{path}:\n  type: sensor\n  datatype: float\n  description: Turns of the engine.\n")
    lint = sigcat("lint", "rpm.vspec", folder=tmp_path)
    export = sigcat("export", "json", "-l", "rpm.vspec", folder=tmp_path)
    assert (lint.returncode, bool(export.returncode)) == (code, bool(code))
    assert message in lint.stdout
    assert message in export.stderr


def test_the_history_of_a_node_is_that_of_the_pulled_releases(tmp_path, monkeypatch, capsys):
    monkeypatch.setattr("sigcat.catalogue.hosting.sources.pulled_sources", lambda: chained_sources(tmp_path))
    chained_sources(tmp_path)
    assert main(["show", "Vehicle.Speed", "--history", "-s", str(tmp_path / "5.0.vspec")]) == 0
    assert capsys.readouterr().out.splitlines() == [
        "Vehicle.Speed",
        "  in 3.1 already",
        "  unit changed in 4.0",
        "    unit           km/h -> m/s  [breaking]",
        "  moved in 4.1 or 4.2 or 5.0 from Vehicle.Velocity",
        "  removed in 5.1 or 6.0",
        "  Not here: 3.0, 4.1, 4.2, 5.1. `sigcat pull v5.1` adds one.",
    ]
    assert main(["show", "Vehicle.Speed", "--history", "--format", "json", "-s", str(tmp_path / "5.0.vspec")]) == 0
    assert [each["kind"] for each in json.loads(capsys.readouterr().out)["events"]] == [
        None, "changed", "moved", "removed",
    ]  # fmt: skip


def test_a_tree_of_no_release_has_no_history(tree, capsys):
    assert main(["show", "Vehicle.Speed", "--history", "-s", "tree.vspec"]) == 0
    assert "does not say which release of VSS" in capsys.readouterr().out


def test_a_function_file_is_not_tried_as_an_overlay(tmp_path, capsys):
    file = tmp_path / "function.yaml"
    file.write_text("function: Demo\ndescription: A function.\nresponsible: Demo team\ncomponents: []\n")
    assert main(["try", str(file)]) == 2
    assert f"{file} is a function file, not an overlay: run `sigcat function validate` on it" in capsys.readouterr().err
