"""The thread that runs the calls has the policy of a parameter, and the declared priority; a refusal is logged."""

import os
import subprocess
import sys
from contextlib import contextmanager, suppress
from pathlib import Path
from shutil import which

import pytest

from scripts import run_ros2
from sigcat.players.ros2_domain import own_domain
from tests.adapter.ros2.built import LANGUAGES, NODES, USUAL, variables, workspace
from tests.adapter.ros2.other_end import ACTIVATE, CONFIGURE, DEACTIVATE, peer
from tests.needs import ros2
from tests.waiting import wait_until

pytestmark = [ros2, pytest.mark.parametrize("language", USUAL)]

NODE = "core_acc"
PRIORITY = 10
"""Priority of the step of CoreAcc, as its function.yaml declares it."""
USUAL_THREAD = (os.SCHED_OTHER, 0)
WARN = 1
_ASKING = "import os; os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(1))"
_MAY = subprocess.run([sys.executable, "-c", _ASKING], check=False, stderr=subprocess.DEVNULL).returncode == 0
real_time = pytest.mark.skipif(not _MAY, reason="the right to real-time policies, as root has it")
WITHOUT_RIGHT = ("setpriv", "--bounding-set=-sys_nice") if os.geteuid() == 0 else ()
refusal = pytest.mark.skipif(
    not which("setpriv") if WITHOUT_RIGHT else _MAY, reason="a user without the right to real-time policies, or setpriv"
)


@contextmanager
def running(language, policy, folder, *prefix):
    """The node, started by a command; who asks it."""
    built = workspace()
    node = built.prefix / "lib" / LANGUAGES[language] / NODES[NODE]
    settings = ("-p", f"scheduling_policy:={policy}", "-p", f"storage_folder:={folder}")
    with own_domain() as number:
        own = variables(built, number, folder)
        command = [*prefix, node, "--ros-args", *settings]
        with run_ros2.started([command], own, folder / "told.txt"), peer(own) as other:
            yield other


def threads(folder):
    """Policy and priority of each thread of the process that has this folder among its arguments."""
    found = set()
    for process in Path("/proc").glob("[0-9]*"):
        with suppress(OSError):  # others end meanwhile
            if f"storage_folder:={folder}".encode() in (process / "cmdline").read_bytes().split(b"\0"):
                numbers = [int(task.name) for task in (process / "task").iterdir()]
                found |= {(os.sched_getscheduler(task), os.sched_getparam(task).sched_priority) for task in numbers}
    return found


@real_time
@pytest.mark.parametrize(("policy", "number"), [("fifo", os.SCHED_FIFO), ("rr", os.SCHED_RR)])
def test_the_calls_alone_run_with_the_policy_and_the_declared_priority(language, policy, number, tmp_path):
    with running(language, policy, tmp_path) as other:
        other.bring(NODE, CONFIGURE)
        assert threads(tmp_path) == {USUAL_THREAD}
        other.bring(NODE, ACTIVATE)
        wait_until(lambda: threads(tmp_path) == {USUAL_THREAD, (number, PRIORITY)}, "the calls have the policy")
        assert other.finds(f"{NODE}: scheduling", lambda found: True)["message"] == ""
        other.bring(NODE, DEACTIVATE)


@refusal
def test_a_policy_that_the_machine_refuses_is_told_and_the_node_runs_on(language, tmp_path):
    with running(language, "fifo", tmp_path, *WITHOUT_RIGHT) as other:
        other.bring(NODE, CONFIGURE, ACTIVATE)
        told = other.finds(f"{NODE}: scheduling", lambda found: found["message"])
        assert told["message"] == "scheduling_policy fifo is refused: Operation not permitted"
        assert told["worst"] == WARN
        assert threads(tmp_path) == {USUAL_THREAD}
        other.switch_on(NODE)
        other.finds(f"{NODE}: CoreAcc_Step", lambda found: int(found["values"]["steps"]) > 2)
