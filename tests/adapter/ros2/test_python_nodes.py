"""The nodes in Python, as processes over real rclpy: another process drives their life by their services."""

import signal
import subprocess
import time
from pathlib import Path

import pytest

from scripts import ros2_environment, run_ros2
from sigcat.data import EXAMPLES
from tests.adapter.ros2.built import interfaces
from tests.adapter.ros2.generated import ecocontrol
from tests.adapter.ros2.python_nodes import domain, install, peer, started, variables
from tests.needs import c_compiler, ros2
from tests.waiting import wait_until

pytestmark = [ros2, c_compiler, pytest.mark.xdist_group("python_nodes")]

CODE = {name: (node, EXAMPLES / node) for name, node in (("CoreAcc", "core_acc"), ("EcoControlMpc", "eco_control_mpc"))}
ANSWER_NOT_TAKEN = Path(__file__).parent / "answer_not_taken_program.py"
REFUSED_PARAMETER = Path(__file__).parent / "refused_parameter_program.py"
MESSAGE_NOT_TAKEN = Path(__file__).parent / "message_not_taken_program.py"
STEP = "eco_control_interfaces/srv/Step"
TRANSITIONS = {"configure": 1, "cleanup": 2, "activate": 3, "deactivate": 4, "shutdown of unconfigured": 5}
UNKNOWN = (0, 60, 99, 255, "create", "nonsense", "transition_success")


@pytest.fixture(scope="module")
def where(tmp_path_factory):
    """EcoControl, installed."""
    return install(ecocontrol(), "eco_control", CODE, interfaces(), tmp_path_factory.mktemp("python"))


@pytest.fixture
def ask(where, tmp_path):
    """The other process."""
    with peer(where, tmp_path) as made:
        yield made


@pytest.fixture
def node(where, tmp_path):
    """CoreAcc, in lock-step."""
    with started(where, "eco_control_py", "core_acc_node", tmp_path, lock_step=True) as made:
        yield made


@pytest.fixture
def running(where, tmp_path):
    """CoreAcc, in time."""
    with started(where, "eco_control_py", "core_acc_node", tmp_path) as made:
        yield made


def kept(folder):
    """Stored values, as lines."""
    return stored_file(folder).read_text().splitlines()


def stored_file(folder):
    """The file of the node in its domain."""
    return folder / f"kept/core_acc-{domain()[0]}.txt"


# -- life ---------------------------------------------------------------------------------------------------------


def test_every_transition_that_a_state_does_not_have_is_refused_and_the_node_lives_on(ask, node):
    ways = [("unconfigured", (2, 3, 4, 6, 7)), ("inactive", (1, 4, 5, 7)), ("active", (1, 2, 3, 5, 6))]
    for (state, wrong), right in zip(ways, (1, 3, 7), strict=True):
        assert ask("state", "core_acc") == state
        refused = [(asked, ask("change", "core_acc", asked)) for asked in (*wrong, *UNKNOWN)]
        assert [asked for asked, success in refused if success] == []
        assert ask("state", "core_acc") == state
        assert ask("change", "core_acc", right)
    assert ask("state", "core_acc") == "finalized"
    assert not any(ask("change", "core_acc", asked) for asked in (*range(1, 9), *UNKNOWN))
    assert node.is_alive()


def test_each_good_initialization_is_terminated_once_and_stored(ask, node, tmp_path):
    for cycle in (1, 2):
        assert ask("change", "core_acc", "configure")
        assert list((tmp_path / "kept").glob("*")) == ([] if cycle == 1 else [stored_file(tmp_path)])
        assert ask("change", "core_acc", "activate")
        assert ask("change", "core_acc", "deactivate")
        assert ask("change", "core_acc", "cleanup")
        assert kept(tmp_path)[0] == "sigcat 1"
        assert f"ignition_cycle: {cycle}" in kept(tmp_path)
    assert ask("change", "core_acc", "shutdown")
    assert "ignition_cycle: 2" in kept(tmp_path)


@pytest.mark.parametrize("has_threads", [False, True], ids=["executor of events", "executor with threads"])
def test_an_answer_that_cannot_be_taken_ends_the_node_with_its_exception(has_threads, where, tmp_path):
    """As in any other callback: the executor of events of rclpy 7.1.6 would die by SIGSEGV."""
    command = (ros2_environment.PYTHON, ANSWER_NOT_TAKEN, str(has_threads))
    ended = subprocess.run(
        command, env=variables(where, tmp_path), capture_output=True, text=True, timeout=60, check=False
    )
    assert ended.returncode == 1
    assert "ValueError: rejected" in ended.stderr.splitlines()


def test_a_message_that_cannot_be_taken_is_left_out_and_told(ask, where, tmp_path):
    """As in C++: the node lives on."""
    said = tmp_path / "said.txt"
    speed = ("publish", "vehicle/speed", "eco_control_interfaces/msg/Speed", {"speed": 50.0}, "reliable")
    told = lambda: said.read_text().count("A message was not taken: rejected")  # noqa: E731
    with run_ros2.started([(ros2_environment.PYTHON, MESSAGE_NOT_TAKEN)], variables(where, tmp_path), said):
        assert ask("change", "core_acc", "configure")
        ask(*speed)
        wait_until(lambda: told() == 1, "it is logged")
        ask(*speed)
        wait_until(lambda: told() == 2, "the next one, too")
        assert ask("state", "core_acc") == "inactive"


@pytest.mark.parametrize("how", [signal.SIGINT, signal.SIGTERM])
def test_a_node_that_is_ended_while_it_is_active_terminates_its_function(ask, running, tmp_path, how):
    assert ask("change", "core_acc", "configure")
    assert ask("change", "core_acc", "activate")
    assert running.end(how) == 0, running.said.read_text()
    assert "ignition_cycle: 1" in kept(tmp_path)


def test_whoever_interrupts_a_node_again_does_not_keep_it_from_terminating_its_function(ask, running, tmp_path):
    assert ask("change", "core_acc", "configure")
    assert ask("change", "core_acc", "activate")
    while running.is_alive():
        running.process.send_signal(signal.SIGINT)
        time.sleep(0.001)
    assert "ignition_cycle: 1" in kept(tmp_path)
    assert "Traceback" not in running.said.read_text()


def test_shutting_an_active_node_down_terminates_its_function(ask, running, tmp_path):
    assert ask("change", "core_acc", "configure")
    assert ask("change", "core_acc", "activate")
    assert ask("change", "core_acc", "shutdown")
    assert "ignition_cycle: 1" in kept(tmp_path)


# -- steps --------------------------------------------------------------------------------------------------------


def test_a_step_of_a_node_that_is_not_active_is_refused(ask, node):
    assert ask("change", "core_acc", "configure")
    answer = ask("step", "core_acc", STEP, 0, 0)
    assert (answer["success"], answer["message"]) == (False, "the node is not active")


def test_a_step_waits_for_the_messages_that_it_names_and_says_if_they_do_not_come(ask, node):
    assert ask("change", "core_acc", "configure")
    assert ask("change", "core_acc", "activate")
    ask("publish", "vehicle/speed", "eco_control_interfaces/msg/Speed", {"speed": 50.0}, "reliable")
    assert ask("step", "core_acc", STEP, 1, 50_000_000)["success"]
    answer = ask("step", "core_acc", STEP, 2, 100_000_000)
    assert (answer["success"], answer["message"]) == (False, "not as many messages have come")


def test_in_simulated_time_nothing_runs_until_the_time_has_come(ask, where, tmp_path):
    with started(where, "eco_control_py", "core_acc_node", tmp_path, use_sim_time=True):
        assert ask("change", "core_acc", "configure")
        ask("publish", "core_acc/mode_in", "eco_control_interfaces/msg/CoreAccModeIn", {"mode": 2}, "reliable")
        ask("listen", "core_acc/cycle50_ms", "eco_control_interfaces/msg/CoreAccCycle50ms")
        assert ask("change", "core_acc", "activate")
        for tick in range(101, 121):
            ask("tick", tick / 10)
            ask("stamps", "core_acc/cycle50_ms", tick - 100)
        stamps = ask("stamps", "core_acc/cycle50_ms", 20)
        assert stamps == [tick * 100_000_000 for tick in range(101, 121)]


# -- parameters ---------------------------------------------------------------------------------------------------


def test_a_parameter_says_what_it_means_and_where_it_ends(ask, node):
    told = ask("describe", "core_acc", "a_lat_max")
    assert told["description"].endswith("limits the speed in curves. Unit: m/s^2.")
    assert (told["ranges"], told["read_only"]) == ([[0.5, 8.0]], False)
    assert ask("describe", "core_acc", "lock_step")["read_only"]


@pytest.mark.parametrize("state", ["unconfigured", "active"])
def test_a_value_out_of_range_or_of_another_type_is_refused(ask, node, state):
    if state == "active":
        assert ask("change", "core_acc", "configure")
        assert ask("change", "core_acc", "activate")
    for value in (0.49, 8.1, -1.0, float("inf"), "fast", True, 3):
        successful, reason = ask("set", "core_acc", {"a_lat_max": value})
        assert (value, successful, bool(reason)) == (value, False, True)
        assert ask("get", "core_acc", ["a_lat_max"]) == [3.0]
    assert ask("set", "core_acc", {"a_lat_max": 8.0})[0]
    assert ask("get", "core_acc", ["a_lat_max"]) == [8.0]


def test_parameters_change_all_or_none(ask, where, tmp_path):
    with started(where, "eco_control_py", "eco_control_mpc_node", tmp_path):
        assert ask("change", "eco_control_mpc", "configure")
        names = ["horizon_step", "energy_weight"]
        assert not ask("set", "eco_control_mpc", {"horizon_step": 30.0, "energy_weight": 1.5})[0]
        assert ask("get", "eco_control_mpc", names) == [20.0, 0.6]
        assert ask("set", "eco_control_mpc", {"horizon_step": 30.0, "energy_weight": 0.5})[0]
        assert ask("get", "eco_control_mpc", names) == [30.0, 0.5]


@pytest.mark.parametrize("release", ["jazzy", "humble"])
def test_a_parameter_that_another_callback_refuses_does_not_reach_the_core(release, where, tmp_path):
    command = (ros2_environment.PYTHON, REFUSED_PARAMETER, release)
    ended = subprocess.run(
        command, env=variables(where, tmp_path), capture_output=True, text=True, timeout=60, check=False
    )
    assert ended.stdout.splitlines() == ["6.0 False 3.0", "4.0 True 4.0"], ended.stderr


def test_a_node_does_not_start_with_a_parameter_out_of_range(where, tmp_path):
    with started(where, "eco_control_py", "core_acc_node", tmp_path, a_lat_max=20.0) as node:
        assert node.process.wait(30.0) == 1
        assert "a_lat_max" in node.said.read_text()
        assert "Traceback" not in node.said.read_text()


# -- logged messages ----------------------------------------------------------------------------------------------

OK, WARN, ERROR = range(3)


def test_an_error_is_told_to_people_as_it_is(ask, running):
    name = "core_acc: CoreAcc_BrakePressureTimeout_ErrorSts"
    assert ask("change", "core_acc", "configure")
    assert ask("diagnostics", "core_acc", name, "state", "NOT_TESTED")["level"] == OK
    ask("publish", "core_acc/mode_in", "eco_control_interfaces/msg/CoreAccModeIn", {"mode": 2}, "reliable")
    assert ask("change", "core_acc", "activate")
    failed = ask("diagnostics", "core_acc", name, "state", "FAILED")
    assert (failed["level"], failed["message"]) == (ERROR, "The brake pressure has not been received in time.")
    assert failed["occurrences"] == "1"


def test_a_publisher_that_promises_too_little_is_counted(ask, running):
    name = "core_acc: subscription core_acc/mode_in"
    assert ask("change", "core_acc", "configure")
    ask("publish", "core_acc/mode_in", "eco_control_interfaces/msg/CoreAccModeIn", {"mode": 2}, "best_effort")
    told = ask("diagnostics", "core_acc", name, "incompatible QoS", "1")
    assert (told["incompatible QoS"], told["messages"]) == ("1", "0")


def test_calls_are_counted_and_measured(ask, running):
    assert ask("change", "core_acc", "configure")
    ask("publish", "core_acc/mode_in", "eco_control_interfaces/msg/CoreAccModeIn", {"mode": 2}, "reliable")
    assert ask("change", "core_acc", "activate")

    def after_many_steps():
        told = ask("diagnostics", "core_acc", "core_acc: CoreAcc_Step", "dropped", "0")
        return told if int(told["steps"]) > 20 else None

    told = wait_until(after_many_steps, "more than 20 steps have run")
    assert float(told["longest t_adapter [us]"]) >= float(told["t_adapter [us]"]) > 0.0


# -- storage ------------------------------------------------------------------------------------------------------


def test_a_file_that_is_broken_is_left_aside_and_told(ask, node, tmp_path):
    file = stored_file(tmp_path)
    for text in (
        "sigcat 2\n",
        "sigcat 1\nignition_cycle: seven\n",
        "sigcat 1\nignition_cycle: 7",
        "sigcat 1\nAliveError\n",
    ):
        file.parent.mkdir(exist_ok=True)
        file.write_text(text)
        assert ask("change", "core_acc", "configure")
        assert file.with_name(f"{file.name}.broken").read_text() == text
        assert ask("change", "core_acc", "cleanup")
        assert "ignition_cycle: 1" in kept(tmp_path)
    assert node.said.read_text().count("is left aside") == 4


def test_counts_of_errors_go_on(ask, node, tmp_path):
    file = stored_file(tmp_path)
    file.parent.mkdir()
    counts = [f"AliveError.{name}: {value}" for name, value in (
        ("occurrences", 3), ("ignition_cycles", 2), ("has_failed", "true"), ("is_tested", "true"))]  # fmt: skip
    file.write_text("\n".join(["sigcat 1", "ignition_cycle: 7", *counts, ""]))
    assert ask("change", "core_acc", "configure")
    assert ask("change", "core_acc", "cleanup")
    assert "ignition_cycle: 8" in kept(tmp_path)
    assert "AliveError.occurrences: 3" in kept(tmp_path)
    assert "AliveError.ignition_cycles: 3" in kept(tmp_path)


WRITER = """
import sys
from pathlib import Path
from eco_control_py.core_acc_core import CoreAccCore
from eco_control_py.support.storage import Storage
core = CoreAccCore()
storage = Storage(Path(sys.argv[1]), core)
cycle = 0
print('ready', flush=True)
while True:
    cycle += 1
    core.init(None, cycle)
    storage.save()
"""


def test_a_file_is_written_whole_or_not_at_all_whenever_the_process_is_killed(where, tmp_path):
    file = tmp_path / "core_acc.txt"
    for after in range(12):
        command = [ros2_environment.PYTHON, "-c", WRITER, file]
        writer = subprocess.Popen(command, env=variables(where, tmp_path), stdout=subprocess.PIPE)
        assert writer.stdout is not None
        assert writer.stdout.readline() == b"ready\n"
        wait_until(file.exists, "it was written once")
        time.sleep(0.0037 * after)  # killed at some moment of its work
        writer.kill()
        writer.wait()
        lines = file.read_text().split("\n")
        assert (lines[0], len(lines), lines[-1]) == ("sigcat 1", 19, "")


TWICE = WRITER.replace("while True:", "for _ in range(200):")


def test_two_nodes_that_end_together_both_store(where, tmp_path):
    file = tmp_path / "core_acc.txt"
    command = [ros2_environment.PYTHON, "-c", TWICE, file]
    writers = [subprocess.Popen(command, env=variables(where, tmp_path), stdout=subprocess.DEVNULL) for _ in range(2)]
    assert [writer.wait() for writer in writers] == [0, 0]
    assert [path.name for path in tmp_path.glob("core_acc*")] == [file.name]
    assert file.read_text().startswith("sigcat 1\n")


# -- the package itself -------------------------------------------------------------------------------------------


def test_the_tests_of_the_package_pass_in_a_domain_of_their_own(where, tmp_path):
    """As pytest runs them for `colcon test`, without a domain in the environment."""
    source = where.source / "eco_control_py"
    own = {name: value for name, value in variables(where, tmp_path).items() if name != "ROS_DOMAIN_ID"}
    done = subprocess.run(
        [ros2_environment.PYTHON, "-m", "pytest", "-q", "-p", "no:cacheprovider", source],
        env=own, cwd=source, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stdout[-3000:]
    assert "12 passed" in done.stdout
