"""Faulty files of units and CAN databases: they are reported first, and what follows from them is not reported."""

import json

import pytest

from sigcat.cli import main

PROJECT = """\
units = ["units.yaml"]
functions = ["functions"]

[[catalogue]]
id = "own"
release = "shipped"
overlays = ["cabin.vspec"]
"""
OVERLAY = """\
Vehicle.Cabin.Smoke:
  type: sensor
  datatype: float
  unit: ppm
  description: Share of smoke in the air of the cabin.
"""
FUNCTION = """\
function: Air
description: Reads the air of the cabin.
responsible: Cabin team
define:
  scheduling:
    Step: {cycleTime: 100, asil: QM, description: Reads.}
components:
  - name: Air
    runnables:
      - interface: Air_Step
        data:
          - {path: Vehicle.Cabin.Smoke, role: consumed, variable: smoke, unit: ppm}
          - {path: Vehicle.Cabin.Unknown, role: consumed, variable: unknown}
"""
PPM = "ppm: {definition: Share., unit: parts per million, quantity: relation, allowed-datatypes: [numeric]}\n"


@pytest.fixture
def lint(tmp_path, monkeypatch, capsys):
    """Lint with a text as the file of units; the findings by place and rule."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "sigcat.toml").write_text(PROJECT)
    (tmp_path / "cabin.vspec").write_text(OVERLAY)
    (tmp_path / "functions").mkdir()

    def run(units, *paths):
        (tmp_path / "units.yaml").write_text(units)
        main(["lint", "--format", "json", *paths])
        found = json.loads(capsys.readouterr().out)["findings"]
        return [f"{each['file']}:{each['line']}:{each['column']} {each['rule']}" for each in found]

    return run


@pytest.mark.parametrize(
    ("units", "finding"),
    [
        (PPM.replace("relation", "relationn"), "units.yaml:1:62 U002"),
        (PPM.replace("definition: Share., ", ""), "units.yaml:1:1 U003"),
        ("ppm: [relation]\n", "units.yaml:1:6 R007"),
        ("ppm:\n  unit: parts: per million\n", "units.yaml:2:14 R001"),
        (f"- {PPM}", "units.yaml:1:1 R007"),
    ],
)
@pytest.mark.parametrize("paths", [(), ("cabin.vspec",)])
def test_an_error_is_reported_and_not_the_units_that_are_unknown_because_of_it(units, finding, paths, lint):
    assert lint(PPM, *paths) == []
    assert lint(units, *paths) == [finding]


def test_a_unit_that_no_file_defines_is_unknown_and_follows_the_error(lint, tmp_path):
    (tmp_path / "cabin.vspec").write_text(OVERLAY.replace("ppm", "foo"))
    assert lint(PPM.replace("relation", "relationn")) == ["units.yaml:1:62 U002", "cabin.vspec:4:9 V006"]


def test_units_of_functions_follow_too(lint, tmp_path):
    (tmp_path / "functions/function.yaml").write_text(FUNCTION)
    found = lint("ppm:\n  unit: parts: per million\n", "functions/function.yaml")
    assert found[0] == "units.yaml:2:14 R001"
    assert "functions/function.yaml:13:20 F010" in found
    assert not any(each.endswith("F021") for each in found)


@pytest.mark.parametrize("units", ["", "# ppm: later\n", "{}\n"])
@pytest.mark.parametrize("paths", [(), ("cabin.vspec",)])
def test_a_file_without_units_is_reported_first(units, paths, lint):
    assert lint(units, *paths) == ["units.yaml:0:0 U009", "cabin.vspec:4:9 V006"]


def test_an_error_of_the_units_is_not_one_of_the_examples_of_a_rule(lint, tmp_path):
    (tmp_path / "rules.yaml").write_text(
        "ACME001:\n  name: gas\n  title: T.\n  severity: error\n  why: W.\n  check: required\n"
        "  options: {attributes: [unit]}\n  nodes: {types: [signals]}\n  source: S\n  good: |\n    Vehicle.Gas: {type: sensor, datatype: float, "
        "unit: ppm, description: Gas.}\n"
    )
    assert lint("ppm: [relation]\n", "rules.yaml", "units.yaml") == ["units.yaml:1:6 R007"]


def test_messages_name_units_and_quantities(lint, tmp_path, capsys):
    (tmp_path / "units.yaml").write_text(f"{PPM}{PPM}1: {{unit: a}}\n")
    (tmp_path / "quantities.yaml").write_text("smell: {definition: A., definition: B.}\nsmell: {definition: A.}\n")
    main(["lint", "units.yaml", "quantities.yaml"])
    said = capsys.readouterr().out
    assert "Unit 'ppm' is given twice, first at units.yaml:1;" in said
    assert "The key of a unit must be text, not 1." in said
    assert "Quantity 'smell' is given twice, first at quantities.yaml:1;" in said
    assert "Field 'definition' is given twice, first at quantities.yaml:1;" in said


def test_an_error_of_a_can_database_comes_before_other_findings(lint, tmp_path):
    (tmp_path / "sigcat.toml").write_text(f'dbc = ["motion.dbc"]\n{PROJECT}')
    (tmp_path / "motion.dbc").write_text("nonsense\n")
    (tmp_path / "cabin.vspec").write_text(OVERLAY.replace("ppm", "foo"))
    assert lint(PPM) == ["motion.dbc:1:0 B001", "cabin.vspec:4:9 V006"]
