"""Many nodes in one process."""

import time
from concurrent.futures import ThreadPoolExecutor

import pytest

from scripts import run_ros2
from sigcat.players.ros2_domain import own_domain
from tests.adapter.ros2.built import LANGUAGES, running, subset, variables, workspace
from tests.adapter.ros2.other_end import ACTIVATE, CLEANUP, CONFIGURE, DEACTIVATE, peer
from tests.needs import ros2

pytestmark = ros2

SPACES = [f"/car{number}" for number in range(19)]
MPC = "eco_control_mpc"


def test_twenty_nodes_live_in_one_process(tmp_path):
    """CoreAcc has its data in global variables, so that it is there once; each of the others has its own."""
    built = workspace()
    wanted = [*(f"eco_control::EcoControlMpcNode={space}" for space in SPACES), "eco_control::CoreAccNode=/car0"]
    command = [subset() / "lib/rclcpp_components/load_components", "eco_control", *wanted]
    nodes = [*(f"{space}/{MPC}" for space in SPACES), "/car0/core_acc"]
    with own_domain() as number:
        own = variables(built, number, tmp_path)
        with run_ros2.started([command], own, tmp_path / "told.txt"), peer(own) as other:
            for node in nodes:
                other.bring(node, CONFIGURE, ACTIVATE)
                other.switch_on(node)
            proposals = [f"{space}/{MPC}/cycle500_ms" for space in SPACES]
            for topic in proposals:
                quality = {"reliability": "BEST_EFFORT"}
                other.listen(topic, "eco_control_interfaces/msg/EcoControlMpcCycle500ms", quality)
            for topic in proposals:
                other.hears(topic, lambda heard: len(heard) >= 3)
            for node in nodes:
                other.bring(node, DEACTIVATE, CLEANUP)


def test_a_function_with_global_variables_is_there_once_in_a_process(tmp_path):
    built = workspace()
    command = [subset() / "lib/rclcpp_components/load_components", "eco_control"]
    twice = ["eco_control::CoreAccNode=/car0", "eco_control::CoreAccNode=/car1"]
    with own_domain() as number:
        status, told = run_ros2.ended([*command, *twice], variables(built, number, tmp_path))
    assert status != 0
    assert "a process can have one node of it" in told


def test_a_node_receives_while_the_one_thread_of_its_process_waits(tmp_path):
    """A step in lock step waits for the message, which comes later."""
    node = f"/car0/{MPC}"
    command = [
        subset() / "lib/rclcpp_components/load_components",
        "eco_control",
        "eco_control::EcoControlMpcNode=/car0",
    ]
    with own_domain() as number:
        own = variables(workspace(), number, tmp_path)
        in_lock_step = [[*command, "--ros-args", "-p", "lock_step:=true"]]
        with (
            run_ros2.started(in_lock_step, own, tmp_path / "told.txt"),
            peer(own) as asking,
            peer(own) as sending,
            ThreadPoolExecutor() as threads,
        ):
            asking.bring(node, CONFIGURE, ACTIVATE)
            answer = threads.submit(asking.step, node, 1, 0, "eco_control_interfaces")
            time.sleep(0.5)  # a message that comes before the question would prove less
            sending.switch_on(node)
            assert answer.result()["success"], answer.result()["message"]


@pytest.mark.parametrize("language", LANGUAGES)
def test_diagnostics_tell_nodes_of_one_name_apart_by_their_namespaces(language, tmp_path):
    with running(language, tmp_path, MPC, arguments=("-r", "__ns:=/fleet/car1")) as other:
        other.bring(f"/fleet/car1/{MPC}", CONFIGURE)
        told = other.finds(f"fleet/car1/{MPC}: EcoControlMpc_Step", bool)
    assert told["values"]["steps"] == "0"
