"""A tree does not differ from its own export, whatever of its instances that shows: what it lacks counts as the tree says."""

from pathlib import Path

import pytest

from sigcat.cli import main

TREE = """\
Vehicle:
  type: branch
  description: A vehicle.
Vehicle.Cabin:
  type: branch
  instances: [Front, Rear]
  description: Part of the cabin.
Vehicle.Cabin.Door:
  type: branch
  instances: ["Row[1,2]", [Left, Right]]
  description: Doors.
Vehicle.Cabin.Door.IsOpen: {type: sensor, datatype: boolean, description: Whether it is open.}
Vehicle.Cabin.Door.Version: {type: attribute, datatype: string, instantiate: false, description: The same for all.}
Vehicle.Cabin.Door.Window:
  type: branch
  instantiate: false
  instances: [Small, Large]
  description: Not one for each door.
Vehicle.Cabin.Door.Window.Position: {type: sensor, datatype: uint8, description: How far it is open.}
Vehicle.Axle:
  type: branch
  instances: Axle[1,2]
  instances_relation: sibling
  description: Axles, which stand beside it.
Vehicle.Axle.Load: {type: sensor, datatype: uint16, description: What it carries.}
Vehicle.Axle.Count: {type: attribute, datatype: uint8, instantiate: false, description: How many there are.}
Vehicle.Mirrors:
  type: branch
  instances: [Left]
  description: One mirror.
Vehicle.Mirrors.Tilt: {type: sensor, datatype: int8, instantiate: false, description: Of all mirrors.}
"""
WAYS: tuple[list[str], ...] = ([], ["--no-expand"], ["--keep-instances"], ["--no-expand", "--keep-instances"])


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    file = tmp_path / "tree.vspec"
    file.write_text(TREE)
    return file


def exported(tree: Path, *options: str) -> Path:
    file = tree.with_suffix(".json")
    assert main(["export", "json", "-s", str(tree), "-o", str(file), *options]) == 0
    return file


@pytest.mark.parametrize("way", WAYS, ids=" ".join)
def test_a_tree_does_not_differ_from_its_export(tree: Path, way: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    export = exported(tree, *way)
    for sides in ((tree, export), (export, tree)):
        assert main(["diff", *map(str, sides)]) == 0
        assert capsys.readouterr().out == "No differences.\n"


@pytest.mark.parametrize("way", WAYS, ids=" ".join)
def test_what_really_changed_is_reported(tree: Path, way: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    export = exported(tree, *way)
    tree.write_text(TREE.replace("datatype: int8", "datatype: string"))
    assert main(["diff", str(export), str(tree), "--fail-on", "breaking"]) == 1
    assert capsys.readouterr().out.count("[breaking]") == 1


def test_a_node_that_gets_instances_is_a_change_beside_an_expanded_export(tree: Path) -> None:
    export = exported(tree)
    tree.write_text(TREE.replace("datatype: int8, instantiate: false", "datatype: int8"))
    assert main(["diff", str(export), str(tree), "--fail-on", "breaking"]) == 1
