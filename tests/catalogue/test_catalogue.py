"""A frozen model: nodes by path, children in order, a content hash."""

import pytest

from tests.catalogue.trees import ROOT, catalogue_of


def signals(*names):
    return ROOT + "".join(f"Vehicle.{name}:\n  type: sensor\n  datatype: float\n  description: D.\n" for name in names)


def test_children_keep_the_order_of_the_files():
    root = catalogue_of(signals("B", "A", "C")).roots[0]
    assert [child.name for child in root.children] == ["B", "A", "C"]


def test_instances_stand_after_what_stands_once():
    tree = ROOT + (
        "Vehicle.Axle:\n  type: branch\n  instances: Row[1,2]\n  description: A.\n"
        "Vehicle.Axle.Speed:\n  type: sensor\n  datatype: float\n  description: S.\n"
        "Vehicle.Axle.Count:\n  type: attribute\n  datatype: uint8\n  instantiate: false\n  description: C.\n"
    )
    assert list(catalogue_of(tree).nodes) == [
        "Vehicle",
        "Vehicle.Axle",
        "Vehicle.Axle.Count",
        "Vehicle.Axle.Row1",
        "Vehicle.Axle.Row1.Speed",
        "Vehicle.Axle.Row2",
        "Vehicle.Axle.Row2.Speed",
    ]


def test_a_node_is_found_by_path_and_so_is_its_parent():
    catalogue = catalogue_of(signals("Speed"))
    speed = catalogue.get("Vehicle.Speed")
    assert speed is not None
    assert catalogue.parent(speed) is catalogue.get("Vehicle")
    assert catalogue.get("Vehicle.Sped") is None


def test_nothing_can_be_changed():
    catalogue = catalogue_of(signals("Speed"))
    with pytest.raises(TypeError):
        catalogue.nodes["Vehicle.New"] = catalogue.nodes["Vehicle"]  # type: ignore[index]
    with pytest.raises(AttributeError):
        catalogue.nodes["Vehicle"].path = "Car"  # type: ignore[misc]


def test_the_hash_is_of_the_content_and_not_of_the_files():
    whole = catalogue_of(signals("A", "B"))
    layered = catalogue_of(signals("A"), signals("B").removeprefix(ROOT))
    assert whole.digest == layered.digest
    assert whole.digest != catalogue_of(signals("A", "C")).digest


def test_a_changed_overlay_leaves_other_definitions_as_they_are():
    before = catalogue_of(signals("A", "B"), "Vehicle.A:\n  min: 0\n")
    after = catalogue_of(signals("A", "B"), "Vehicle.A:\n  min: 1\n", earlier=before)
    assert after.nodes["Vehicle.A"].values["min"] == 1
    assert after.digest == catalogue_of(signals("A", "B"), "Vehicle.A:\n  min: 1\n").digest
