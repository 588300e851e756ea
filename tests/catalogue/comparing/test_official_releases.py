"""Changes from VSS 5.0 to 6.0, checked by hand against both trees."""

from collections import Counter
from functools import cache, partial
from statistics import median

import pytest

from sigcat.catalogue.comparing.changes import Change
from sigcat.catalogue.comparing.diff import compare
from sigcat.catalogue.comparing.sides import read_side
from sigcat.errors import NotFound
from tests.growth import ratio
from tests.needs import OFFICIAL, official_releases

pytestmark = official_releases


def no_release(name):
    raise NotFound(name)


@cache
def side(release):
    return read_side(str(OFFICIAL / release), no_release).catalogue


@cache
def changes() -> tuple[Change, ...]:
    return compare(side("v5.0"), side("v6.0"))


def the(kind, path) -> Change:
    """The change of this kind at a path, which is the former one for what moved."""
    (found,) = [change for change in changes() if change.kind == kind and (change.former or change.path) == path]
    return found


def test_so_many_changes_of_each_kind_and_class():
    assert Counter(change.kind for change in changes()) == {"added": 54, "changed": 26, "moved": 13, "removed": 7}
    assert Counter(change.compatibility for change in changes()) == {"breaking": 26, "risky": 19, "compatible": 55}


def test_every_path_of_either_tree_is_explained():
    old, new = side("v5.0").nodes, side("v6.0").nodes
    assert min(len(old), len(new)) > 1_000
    gone = [p for c in changes() if c.kind == "removed" for p in c.paths]
    gone += [p for c in changes() for p in (*c.went, *c.former_paths)]
    came = [p for c in changes() if c.kind in ("added", "moved") for p in c.paths]
    came += [p for c in changes() for p in c.came]

    def is_below(path, tops):
        return any(path == top or path.startswith(f"{top}.") for top in tops)

    assert [path for path in old if path not in new and not is_below(path, gone)] == []
    assert [path for path in new if path not in old and not is_below(path, came)] == []


def test_no_signal_is_lost_from_the_count():
    old, new = (sum(node.is_leaf for node in side(release).nodes.values()) for release in ("v5.0", "v6.0"))
    added = sum(c.leaves for c in changes() if c.kind == "added")
    removed = sum(c.leaves for c in changes() if c.kind == "removed")
    new_places = sum(len(c.paths) for c in changes() if c.kind == "moved" and c.path not in side("v5.0").definitions)
    old_places = sum(c.leaves for c in changes() if c.kind == "moved")
    detection = the("changed", "Vehicle.ADAS.ObstacleDetection")
    by_instances = 6 * 6 - len(detection.went)
    assert new - old == added + new_places + by_instances - removed - old_places


@pytest.mark.parametrize(
    ("path", "instances", "leaves"),
    [
        ("Vehicle.OBD", 1, 117),
        ("Vehicle.Driver.Identifier", 1, 2),
        ("Vehicle.Cabin.Seat.Switch", 6, 144),
        ("Vehicle.Cabin.Seat.Occupant", 6, 12),
        ("Vehicle.Cabin.Seat.IsOccupied", 6, 6),
        ("Vehicle.Cabin.Seat.Backrest.Lumbar", 6, 0),
    ],
)
def test_a_branch_that_is_gone_is_one_breaking_change(path, instances, leaves):
    change = the("removed", path)
    assert (change.compatibility, len(change.paths), change.leaves) == ("breaking", instances, leaves)


@pytest.mark.parametrize(
    ("path", "leaves"),
    [("Vehicle.MotionManagement", 99), ("Vehicle.ControlUnit", 66), ("Vehicle.Powertrain.RangeExtender", 6)],
)
def test_a_branch_that_is_new_is_one_compatible_change(path, leaves):
    change = the("added", path)
    assert (change.compatibility, change.paths, change.leaves) == ("compatible", (path,), leaves)


@pytest.mark.parametrize(
    ("former", "path"),
    [
        ("CombustionEngine.ECT", "CombustionEngine.EngineCoolant.Temperature"),
        ("CombustionEngine.EOT", "CombustionEngine.EngineOil.Temperature"),
        ("CombustionEngine.EngineOilLevel", "CombustionEngine.EngineOil.Level"),
        ("CombustionEngine.EngineOilCapacity", "CombustionEngine.EngineOil.Capacity"),
        ("CombustionEngine.OilLifeRemaining", "CombustionEngine.EngineOil.LifeRemaining"),
        ("CombustionEngine.EngineCoolantCapacity", "CombustionEngine.EngineCoolant.Capacity"),
        ("ElectricMotor.CoolantTemperature", "ElectricMotor.EngineCoolant.Temperature"),
    ],
)
def test_what_5_0_announced_to_move_has_moved(former, path):
    change = the("moved", f"Vehicle.Powertrain.{former}")
    assert (change.path, change.evidence, change.is_guess) == (f"Vehicle.Powertrain.{path}", "deprecation", False)


@pytest.mark.parametrize("name", ["DTCList", "Status.DTCCount"])
def test_two_signals_of_the_obd_branch_are_replaced(name):
    change = the("moved", f"Vehicle.OBD.{name}")
    assert change.path == f"Vehicle.Diagnostics.{name.rpartition('.')[2]}"


@pytest.mark.parametrize(
    ("former", "path"),
    [
        ("Massage", "Massage.Level"),
        ("Backrest.Lumbar.Height", "Backrest.LumbarHeight"),
        ("Backrest.Lumbar.Support", "Backrest.LumbarSupport"),
        ("Backrest.SideBolster.Support", "Backrest.SideBolsterSupport"),
    ],
)
def test_four_signals_of_the_seat_are_guessed_to_have_moved(former, path):
    change = the("moved", f"Vehicle.Cabin.Seat.{former}")
    assert (change.path, change.is_guess, len(change.paths)) == (f"Vehicle.Cabin.Seat.{path}", True, 6)


def test_obstacle_detection_got_instances():
    change = the("changed", "Vehicle.ADAS.ObstacleDetection")
    assert change.compatibility == "breaking"
    assert [(a.name, a.old, a.new) for a in change.attributes] == [
        ("instances", None, [["Front", "Rear"], ["Left", "Center", "Right"]])
    ]
    assert change.came == ("Vehicle.ADAS.ObstacleDetection.Front", "Vehicle.ADAS.ObstacleDetection.Rear")
    assert {path.rpartition(".")[2] for path in change.went} == {"IsEnabled", "IsWarning", "IsError"}


@pytest.mark.parametrize(
    ("path", "attributes"),
    [
        ("TraveledDistance", {"datatype": ("float", "uint32"), "unit": ("km", "m")}),
        ("TraveledDistanceSinceStart", {"datatype": ("float", "uint32"), "unit": ("km", "m")}),
        ("TripMeterReading", {"datatype": ("float", "uint32"), "unit": ("km", "m")}),
        ("Powertrain.CombustionEngine.Speed", {"datatype": ("uint16", "float")}),
        ("Powertrain.ElectricMotor.Speed", {"datatype": ("int32", "float")}),
    ],
)
def test_datatypes_and_units_that_changed_are_breaking(path, attributes):
    change = the("changed", f"Vehicle.{path}")
    assert change.compatibility == "breaking"
    assert {a.name: (a.old, a.new) for a in change.attributes} == attributes


def test_celsius_with_a_capital_is_risky_and_nothing_more():
    respelled = [c for c in changes() if c.rule == "unit-respelled"]
    assert len(respelled) == 17
    assert sum(len(change.paths) for change in respelled) == 27
    assert {(a.old, a.new) for c in respelled for a in c.attributes if a.name == "unit"} == {("celsius", "Celsius")}
    assert {change.compatibility for change in respelled} == {"risky"}


def test_a_signal_of_four_wheels_is_one_change():
    change = the("changed", "Vehicle.Chassis.Axle.Wheel.Tire.Temperature")
    assert change.paths[0] == "Vehicle.Chassis.Axle.Row1.Wheel.Left.Tire.Temperature"
    assert len(change.paths) == 4
    assert [(a.name, a.compatibility) for a in change.attributes] == [("unit", "risky"), ("deprecation", "compatible")]


def test_the_deprecation_of_pan_names_a_sibling_that_is_not_yet_its_successor():
    assert the("changed", "Vehicle.Body.Mirrors.Pan").compatibility == "compatible"
    assert the("added", "Vehicle.Body.Mirrors.Yaw").leaves == 2


def test_the_rest():
    assert the("changed", "Vehicle.VehicleIdentification.VIN").rule == "pattern"
    assert the("changed", "Vehicle.VersionVSS.Major").rule == "default"


def test_it_takes_less_time_than_to_read_one_of_them():
    old, new = side("v5.0"), side("v6.0")
    reading = partial(read_side, str(OFFICIAL / "v5.0"), no_release)
    assert median(ratio(partial(compare, old, new), reading) for _ in range(3)) < 1
