"""Trees of struct types: found, linted as separate trees, and known to the trees that use them."""

from pathlib import Path

import pytest

from sigcat.rules.linting.lint import lint_paths
from sigcat.rules.linting.options import LintOptions

TREE = """\
Vehicle: {type: branch, description: A vehicle.}
Vehicle.Position: {type: sensor, datatype: Types.Location, description: Where it is.}
"""
TYPES = """\
Types: {type: branch, description: Types.}
Types.Location:
  type: struct
  description: a location.
Types.Location.latitude:
  type: property
  datatype: doubl
  description: Latitude.
"""


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "spec").mkdir()
    (tmp_path / "spec" / "VehicleSignalSpecification.vspec").write_text(TREE)
    (tmp_path / "types.vspec").write_text(TYPES)
    return tmp_path


def told(result):
    return [(Path(f.file).name, f.line, f.rule) for f in result.findings]


IN_TYPES = [("types.vspec", 4, "V105"), ("types.vspec", 5, "V101"), ("types.vspec", 7, "V003")]


def test_types_beside_a_tree_are_found_and_used(folder):
    assert told(lint_paths([folder])) == IN_TYPES


def test_types_named_alone_are_linted_as_types(folder):
    assert told(lint_paths([folder / "types.vspec"])) == IN_TYPES


def test_a_tree_named_alone_knows_the_types_of_the_options(folder):
    (folder / "types.vspec").write_text(TYPES.replace("doubl", "double"))
    assert told(lint_paths([folder / "spec"])) == [("VehicleSignalSpecification.vspec", 2, "V003")]
    assert told(lint_paths([folder / "spec"], LintOptions(types=(folder / "types.vspec",)))) == []


def test_an_overlay_may_use_a_struct(folder):
    (folder / "types.vspec").write_text(TYPES.replace("doubl", "double"))
    overlay = folder / "more.vspec"
    overlay.write_text("Vehicle.Home: {type: attribute, datatype: Types.Location, description: Where it lives.}\n")
    assert told(lint_paths([overlay], LintOptions(types=(folder / "types.vspec",)))) == []
    assert told(lint_paths([overlay.rename(folder / "spec" / "more.vspec")])) == [("more.vspec", 1, "V003")]


def test_types_in_the_folder_of_a_tree_or_an_overlay_are_known_to_it_when_it_is_named_alone(folder):
    """As pre-commit names changed files."""
    types = folder / "spec" / "types.vspec"
    types.write_text(TYPES.replace("doubl", "double"))
    assert told(lint_paths([folder / "spec" / "VehicleSignalSpecification.vspec"])) == []
    (folder / "overlays").mkdir()
    (folder / "types.vspec").rename(folder / "overlays" / "own.vspec")
    own = folder / "overlays" / "own.vspec"
    own.write_text(TYPES.replace("doubl", "double").replace("Types", "Own"))
    overlay = folder / "overlays" / "more.vspec"
    overlay.write_text("Vehicle.Home: {type: attribute, datatype: Own.Location, description: Where it lives.}\n")
    assert told(lint_paths([overlay])) == []
    assert told(lint_paths([own])) == [("own.vspec", 4, "V105"), ("own.vspec", 5, "V101")]
