"""Units and quantities that are named beside overlays."""

import pytest

from sigcat.cli import main
from sigcat.data import VSPEC

OVERLAY = """\
Vehicle.Quality:
  type: sensor
  datatype: float
  unit: {}
  description: Quality of the road.
"""
UNITS = """\
hp:
  definition: Horse power.
  unit: horse power
  quantity: power
  allowed-datatypes: ['numeric']
ql:
  definition: Level of quality.
  unit: quality level
  quantity: quality
  allowed-datatypes: ['numeric']
"""
QUANTITIES = "quality:\n  definition: How good something is.\n"


@pytest.fixture
def files(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "overlays").mkdir()
    (tmp_path / "units.yaml").write_text(UNITS)
    (tmp_path / "quantities.yaml").write_text(QUANTITIES)
    return tmp_path


@pytest.mark.parametrize("unit", ["hp", "ql"])
def test_they_count_for_overlays_in_other_folders(unit, files, capsys):
    (files / "overlays/a.vspec").write_text(OVERLAY.format(unit))
    assert main(["lint", "overlays", "units.yaml", "quantities.yaml"]) == 0, capsys.readouterr().out


def test_units_alone_know_the_quantities_of_the_shipped_tree(files, capsys):
    assert main(["lint", "units.yaml"]) == 0, capsys.readouterr().out


def test_a_quantity_that_no_file_has_is_reported_once(files, capsys):
    (files / "overlays/a.vspec").write_text(OVERLAY.format("ql"))
    (files / "units.yaml").write_text(UNITS.replace("quantity: power", "quantity: nothing"))
    assert main(["lint", "overlays", "units.yaml", "quantities.yaml"]) == 1
    said = capsys.readouterr().out
    assert said.count("U002") == 1
    assert "Found 1 error in 1 file." in said


def test_a_quantity_is_in_lower_case_as_vss_tools_wants_it(files, capsys):
    (files / "units.yaml").write_text(UNITS.replace("quantity: power", "quantity: Power"))
    assert main(["lint", "units.yaml", "quantities.yaml"]) == 1
    assert "must be in lower case, not 'Power': vss-tools refuses it. Write 'power'." in capsys.readouterr().out


@pytest.mark.parametrize("more", ["", UNITS])
def test_a_copy_of_the_shipped_units_replaces_nothing(more, files, capsys):
    (files / "overlays/a.vspec").write_text(OVERLAY.format("km/h"))
    (files / "units.yaml").write_text((VSPEC / "units.yaml").read_text() + more)
    (files / "quantities.yaml").write_text((VSPEC / "quantities.yaml").read_text() + QUANTITIES)
    assert main(["lint", "overlays", "units.yaml", "quantities.yaml"]) == 0, capsys.readouterr().out


def test_another_definition_of_a_unit_is_reported(files, capsys):
    (files / "overlays/a.vspec").write_text(OVERLAY.format("km/h"))
    (files / "units.yaml").write_text(UNITS.replace("hp:", "kW:").replace("horse power", "power of a horse"))
    main(["lint", "overlays", "units.yaml", "quantities.yaml"])
    assert "U004 Unit 'kW' replaces the one at" in capsys.readouterr().out


@pytest.mark.parametrize("checked", ["units.yaml", "."])
def test_units_alone_are_compared_with_those_of_vss(files, capsys, checked):
    (files / "units.yaml").write_text("kmh:\n  definition: Speed.\n  unit: kilometer per hour\n  quantity: velocity\n")
    assert main(["lint", checked]) == 1
    said = capsys.readouterr().out
    assert "U001 Units 'km/h' and 'kmh' share the name 'kilometer per hour'. Remove 'kmh' and use 'km/h'." in said


def test_quantities_alone_are_compared_with_those_of_vss(files, capsys):
    (files / "quantities.yaml").write_text("Velocity:\n  definition: Speed.\n")
    assert main(["lint", "quantities.yaml"]) == 1
    assert "U004 Quantity 'Velocity' replaces 'velocity'" in capsys.readouterr().out


def test_units_beside_a_tree_of_their_own_are_not_compared_with_those_of_vss(files, capsys):
    (files / "tree.vspec").write_text("Car: {type: branch, description: A car.}\n")
    (files / "units.yaml").write_text(UNITS.replace("hp:", "kW:"))
    (files / "quantities.yaml").write_text(QUANTITIES)
    main(["lint", "units.yaml"])
    assert "U004" not in capsys.readouterr().out
