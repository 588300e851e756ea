"""Trees in the layouts of older releases load, with a warning for what is written otherwise today."""

from pathlib import Path

import pytest

from scripts.cases import OLDER_RELEASES
from sigcat.catalogue.hosting.source import Source, load
from sigcat.catalogue.model.catalogue import Catalogue
from sigcat.data import ROOT_FILE
from sigcat.findings import has_errors

CASES = Path(__file__).parent / "older"


def loaded(name: str, *overlays: str, release: str = "") -> Catalogue:
    folder = CASES / name
    root = folder / "VehicleSignalSpecification.vspec"
    return load(Source("old", "Old", root, tuple(folder / overlay for overlay in overlays), release=release))


@pytest.mark.parametrize("name", OLDER_RELEASES.names)
def test_findings_are_as_expected_and_none_is_an_error(name):
    assert OLDER_RELEASES.made(name) == OLDER_RELEASES.text(name), "If that is meant, run `make generate`."
    assert not has_errors(loaded(name).findings)


def test_units_in_the_layout_of_3_1_are_known_by_key_and_by_label():
    vocabulary = loaded("units_of_3.1_and_4.0").vocabulary
    assert vocabulary.units["km/h"].name == "kilometer per hour"
    assert vocabulary.units["kilometer per hour"].key == "km/h"
    assert vocabulary.units["km/h"].quantity == "speed"
    assert vocabulary.units["km/h"].origin[1:3] == (3, 3)
    assert set(vocabulary.quantities) == {"speed", "point in time", "relation"}
    assert [unit.key for unit in vocabulary.distinct_units] == ["km/h", "UNIX Timestamp", "percent"]


def test_units_of_3_1_go_with_any_datatype():
    catalogue = loaded("units_of_3.1_and_4.0")
    assert catalogue.nodes["Vehicle.Label"].values["unit"] == "percent"


def test_a_tree_of_3_0_gets_the_shipped_units_and_those_of_its_tools():
    catalogue = loaded("no_units_as_in_3.0")
    shipped = load(Source("vss", "VSS", ROOT_FILE)).vocabulary
    assert set(catalogue.vocabulary.units) == set(shipped.units) | {"unix timestamp", "mb", "mb/s"}
    assert catalogue.unit(catalogue.nodes["Vehicle.StartTime"]) is catalogue.vocabulary.units["unix timestamp"]


def test_a_unit_in_a_tree_of_3_0_keeps_the_spelling_of_that_time():
    catalogue = loaded("no_units_as_in_3.0")
    assert catalogue.nodes["Vehicle.Heat"].values["unit"] == "celsius"
    assert [unit.key for unit in catalogue.vocabulary.distinct_units if unit.key.lower() == "celsius"] == ["celsius"]


def test_units_of_4_1_keep_what_is_written_as_today():
    vocabulary = loaded("units_of_4.1_and_4.2").vocabulary
    assert vocabulary.units["ml"].definition == "Volume, metric."
    assert vocabulary.units["kg"].name == "kilogram"
    assert vocabulary.units["months"].name == "months"
    assert vocabulary.units["unix-time"].allowed_datatypes == ("uint32",)


def test_words_of_before_are_read_as_the_present_ones():
    nodes = loaded("words_of_before_3.0").nodes
    assert nodes["Vehicle.State"].values["allowed"] == ["OFF", "ON"]
    assert nodes["Vehicle.Doors"].values["default"] == 4
    assert nodes["Vehicle.Body"].type == "branch"


def test_a_type_may_be_written_in_capitals():
    nodes = loaded("as_written_between_3.0_and_4.0").nodes
    assert nodes["Vehicle.IsLocked"].type == nodes["Vehicle.Spare.IsLocked"].type == "actuator"


def test_values_of_the_time_are_what_they_are_today():
    nodes = loaded("as_written_between_3.0_and_4.0").nodes
    assert nodes["Vehicle.Plugs"].values["allowed"] == ["AC", "DC", "OTHER"]
    assert nodes["Vehicle.Rows"].values["default"] == [2, 3]
    assert nodes["Vehicle.Charge"].values["max"] == 100
    assert nodes["Vehicle.IsLocked"].values["default"] is False
    assert nodes["Vehicle.Brake.IsDefect"].values["datatype"] == "boolean"


def test_values_of_another_kind_are_kept_as_written():
    nodes = loaded("values_of_other_kinds").nodes
    kept = {name: nodes[f"Vehicle.{name}"].values for name in ("Old", "Rows", "Mode", "Lowest")}
    assert kept["Old"]["deprecation"] == 3.1
    assert kept["Rows"]["default"] == "[2, 3]"
    assert kept["Mode"]["allowed"] == 3
    assert (kept["Lowest"]["min"], kept["Lowest"]["max"]) == ("none", 100)


def test_a_renamed_attribute_keeps_its_place():
    catalogue = loaded("words_of_before_3.0")
    assert catalogue.origin(catalogue.nodes["Vehicle.State"], "allowed")[1:3] == (8, 9)


def test_instances_of_the_time_are_expanded():
    assert [n.path for n in loaded("instances").nodes.values() if n.is_leaf] == [
        "Vehicle.Door.Row1.Left.IsOpen",
        "Vehicle.Door.Row1.Right.IsOpen",
        "Vehicle.Door.Row2.Left.IsOpen",
        "Vehicle.Door.Row2.Right.IsOpen",
        "Vehicle.Seat.Pos1.IsOccupied",
        "Vehicle.Seat.Pos2.IsOccupied",
        "Vehicle.Mirror.Left.IsFolded",
        "Vehicle.Mirror.Right.IsFolded",
    ]


def test_an_instance_may_have_a_definition_of_its_own():
    nodes = loaded("instances_with_definitions_of_their_own").nodes
    assert [node.path for node in nodes.values() if node.is_leaf] == [
        "Vehicle.Lights.Beam.Low.IsOn",
        "Vehicle.Lights.Beam.High.IsOn",
        "Vehicle.Lights.Fog.IsOn",
        "Vehicle.Axle.Row1.Wheel.Left.Speed",
        "Vehicle.Axle.Row1.Wheel.Right.Speed",
        "Vehicle.Axle.Row2.Wheel.Left.Speed",
        "Vehicle.Axle.Row2.Wheel.Right.Speed",
    ]


def test_an_overlay_of_ones_own_stays_under_todays_checks():
    findings = loaded("units_of_3.1_and_4.0", "overlay.vspec").findings
    assert [(f.rule, f.severity) for f in findings if "overlay.vspec" in f.file] == [("V006", "error")]


def test_a_tree_without_units_has_those_of_vss_unless_it_says_otherwise(tmp_path):
    tree = tmp_path / "tree.vspec"
    tree.write_text("Vehicle:\n  type: branch\nVehicle.Speed:\n  type: sensor\n  datatype: float\n  unit: km/h\n")
    source = Source("own", "Own", tree)
    assert load(source).nodes["Vehicle.Speed"].values["unit"] == "km/h"
    assert not has_errors(load(source).findings)
    without = load(source._replace(has_standard_units=False))
    assert [f.rule for f in without.findings if f.severity == "error"] == ["U007"]


def test_errors_of_an_official_release_are_warnings_and_those_of_a_tree_of_ones_own_are_errors(tmp_path):
    tree = tmp_path / "tree.vspec"
    tree.write_text("Vehicle:\n  type: branch\nVehicle.Speed:\n  type: sensor\n  datatype: flaot\n")
    severities = [load(Source("t", "T", tree, release=name)).findings[0].severity for name in ("", "v5.0")]
    assert severities == ["error", "warning"]


def test_what_is_no_tree_is_an_error_in_any_release(tmp_path):
    tree = tmp_path / "tree.vspec"
    tree.write_text("A.B:\n  type: branch\n")
    assert has_errors(load(Source("t", "T", tree, release="v5.0")).findings)
