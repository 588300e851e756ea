"""Every value knows where it came from: file, line, column, and the overlay that set it."""

from sigcat.catalogue.reading.statement import Origin
from tests.catalogue.trees import ROOT, catalogue_of

TREE = ROOT + (
    "Vehicle.Speed:\n"  # line 4
    "  type: sensor\n"
    "  datatype: float\n"
    "  min: 0\n"
    "  description:\n"
    "    Speed of the vehicle.\n"
)
OVERLAY = "Vehicle.Speed:\n  min: -10\n  max: 250\n"


def node(path, *overlays):
    found = catalogue_of(TREE, *overlays).get(path)
    assert found is not None
    return found


def test_a_node_is_where_its_key_is():
    assert node("Vehicle.Speed").definition.origin() == Origin("tree", 4, 1)


def test_a_value_is_where_it_was_written():
    assert node("Vehicle.Speed").definition.origin("datatype") == Origin("tree", 6, 13)


def test_a_value_on_the_line_after_its_name():
    assert node("Vehicle.Speed").definition.origin("description") == Origin("tree", 9, 5)


def test_an_overlay_that_changes_a_value_is_its_origin():
    definition = node("Vehicle.Speed", OVERLAY).definition
    assert definition.origin("min") == Origin("overlay1", 2, 8, "overlay1")
    assert definition.origin("datatype") == Origin("tree", 6, 13)


def test_the_history_of_a_value_is_kept_from_the_base_on():
    second = "Vehicle.Speed:\n  min: -20\n"
    history = node("Vehicle.Speed", OVERLAY, second).definition.history("min")
    assert history == (
        (0, Origin("tree", 7, 8)),
        (-10, Origin("overlay1", 2, 8, "overlay1")),
        (-20, Origin("overlay2", 2, 8, "overlay2")),
    )


def test_a_pattern_is_the_origin_of_what_it_sets():
    assert node("Vehicle.Speed", "Vehicle.*:\n  min: 1\n").definition.origin("min").overlay == "overlay1"


def test_an_instance_knows_the_branch_that_it_came_from():
    tree = ROOT + (
        "Vehicle.Door:\n  type: branch\n  instances: [Left, Right]\n  description: D.\n"
        "Vehicle.Door.IsOpen:\n  type: actuator\n  datatype: boolean\n  description: O.\n"
    )
    catalogue = catalogue_of(tree, "Vehicle.Door.Left.IsOpen:\n  comment: Only here.\n")
    left, right = catalogue.nodes["Vehicle.Door.Left.IsOpen"], catalogue.nodes["Vehicle.Door.Right.IsOpen"]
    assert left.template == right.template == "Vehicle.Door.IsOpen"
    assert left.definition.origin("comment") == Origin("overlay1", 2, 12, "overlay1")
    assert right.values.get("comment") is None
    assert catalogue.nodes["Vehicle.Door.Left"].definition.is_instance
    assert not catalogue.nodes["Vehicle.Door"].definition.is_instance
