"""A package of the user links a generated node, and derives from it: for its publishers, timers and transforms."""

from pathlib import Path

from scripts import ros2_packages, run_ros2
from sigcat.players.ros2_domain import own_domain
from tests.adapter.ros2.built import variables, workspace
from tests.adapter.ros2.other_end import ACTIVATE, CONFIGURE, peer
from tests.needs import ros2

pytestmark = ros2

NODE = "core_acc"
HEARD = {"reliability": "BEST_EFFORT"}


def test_a_class_that_derives_from_a_node_has_publishers_of_its_own_and_completes_messages(tmp_path):
    built = workspace()
    source = Path(__file__).with_name("derived")
    prefix = ros2_packages.build_cmake(source, tmp_path, tmp_path / "install", built.prefix, *built.others)
    whole = run_ros2.Workspace(prefix, (built.prefix, *built.others))
    with own_domain() as number:
        own = variables(whole, number, tmp_path)
        command = [prefix / "lib/derived/derived_node"]
        with run_ros2.started([command], own, tmp_path / "told.txt"), peer(own) as other:
            other.listen("counted", "std_msgs/msg/UInt32", HEARD)
            other.listen(f"{NODE}/cycle50_ms", "eco_control_interfaces/msg/CoreAccCycle50ms", HEARD)
            other.bring(NODE, CONFIGURE, ACTIVATE)
            other.switch_on(NODE)
            other.hears("counted", bool)
            heard = other.hears(f"{NODE}/cycle50_ms", bool)
            assert heard[0]["stamp"]["sec"] == 7
            for value, is_taken in ((4.0, True), (6.0, False)):
                assert other.set_all_parameters(NODE, {"a_lat_max": value})[0] is is_taken
            assert other.parameters(NODE, ["a_lat_max"]) == [4.0]
