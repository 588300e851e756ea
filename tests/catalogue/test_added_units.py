"""Units and quantities add to those of the tree; a key that gets another meaning is a finding."""

import shutil

import pytest

from sigcat.catalogue.composing.compose import read_catalogue
from sigcat.catalogue.model.vocabulary import STANDARD_QUANTITIES, STANDARD_UNITS
from sigcat.data import ROOT_FILE

PPM = "ppm:\n  definition: Parts per million.\n  unit: parts per million\n  quantity: relation\n  allowed-datatypes: ['numeric']\n"
LIGHT_YEAR = PPM.replace("ppm:", "l:").replace("relation", "length")
TREE = "Vehicle:\n  type: branch\n  description: A vehicle.\nVehicle.Gas:\n  type: sensor\n  datatype: float\n  unit: ppm\n  description: Gas.\n"


def rules(catalogue):
    return [(finding.rule, finding.file.rpartition("/")[2]) for finding in catalogue.findings]


@pytest.fixture
def units(tmp_path):
    file = tmp_path / "own_units.yaml"
    file.write_text(PPM)
    return file


def test_units_that_are_given_add_to_those_beside_the_tree(units):
    catalogue = read_catalogue(ROOT_FILE, units=[units])
    assert {"ppm", "km/h"} <= set(catalogue.vocabulary.units)
    assert rules(catalogue) == []


def test_units_beside_an_overlay_are_read_as_in_a_lint(tmp_path):
    (tmp_path / "units.yaml").write_text(PPM)
    (tmp_path / "gas.vspec").write_text(
        "Vehicle.Cabin.Gas:\n  type: sensor\n  datatype: float\n  unit: ppm\n  description: Gas.\n"
    )
    assert rules(read_catalogue(ROOT_FILE, [tmp_path / "gas.vspec"])) == []


def test_a_tree_without_units_has_those_of_vss_and_their_quantities(tmp_path, units):
    tree = tmp_path / "tree.vspec"
    tree.write_text(TREE)
    catalogue = read_catalogue(tree, units=[units])
    assert rules(catalogue) == []
    assert "km/h" in catalogue.vocabulary.units
    alone = read_catalogue(tree, units=[units], has_standard_units=False)
    assert [unit.key for unit in alone.vocabulary.distinct_units] == ["ppm"]
    assert rules(alone) == [("U008", "own_units.yaml")]


def test_a_quantity_that_vss_defines_is_known_though_the_tree_has_its_own(tmp_path):
    (tmp_path / "tree.vspec").write_text(TREE)
    (tmp_path / "units.yaml").write_text(PPM)
    (tmp_path / "quantities.yaml").write_text("smell:\n  definition: Intensity of a smell.\n")
    catalogue = read_catalogue(tmp_path / "tree.vspec")
    assert rules(catalogue) == []
    assert set(catalogue.vocabulary.quantities) == {"smell", "relation"}


def test_another_meaning_of_a_key_is_a_finding_and_the_same_is_not(tmp_path, units):
    copy = shutil.copy(units, tmp_path / "copy.yaml")
    units_of_vss = shutil.copy(STANDARD_UNITS, tmp_path / "vss_units.yaml")
    quantities_of_vss = shutil.copy(STANDARD_QUANTITIES, tmp_path / "vss_quantities.yaml")
    given = [units, units, tmp_path / copy, tmp_path / units_of_vss, STANDARD_UNITS]
    assert rules(read_catalogue(ROOT_FILE, units=given, quantities=[tmp_path / quantities_of_vss])) == []
    units.write_text(LIGHT_YEAR)
    assert rules(read_catalogue(ROOT_FILE, units=[units])) == [("U004", "own_units.yaml")]
