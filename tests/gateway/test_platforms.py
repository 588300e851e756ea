"""EcoControl's log of CAN, carried to real processes while they run: they send what they send of the trace, bit for bit."""

import csv
import gzip
import os
import shlex
import subprocess
import sys
from pathlib import Path

import pytest

from sigcat.adapter.toolchain import toolchain
from sigcat.comparison.behaviour import in_lock_step
from sigcat.comparison.running.processes import own_network
from sigcat.comparison.running.recorded import read_recorded
from sigcat.comparison.running.runner import Drive
from sigcat.comparison.running.table import RUNNERS
from sigcat.players.ros2_environment import installed
from sigcat.runs.recording.times import nanoseconds
from tests import needs
from tests.comparison.ecocontrol import DRIVE, EXAMPLES, subject
from tests.comparison.running.test_platforms import changes

pytestmark = needs.slow
CAN = EXAMPLES / "ecocontrol/can"
SECONDS = 35
LOOPBACK_UP = (
    "import fcntl, socket, struct; fcntl.ioctl(socket.socket(socket.AF_INET, socket.SOCK_DGRAM), "
    "0x8914, struct.pack('16sH14x', b'lo', 1))"
)


@pytest.fixture(scope="module")
def drive(tmp_path_factory):
    """The first seconds of the log, and what does not come from CAN."""
    folder = tmp_path_factory.mktemp("drive")
    with gzip.open(CAN / "drive.log.gz", "rt") as log:
        lines = [line for line in log if float(line[1:].partition(")")[0]) <= SECONDS]
    (folder / "drive.log").write_text("".join(lines))
    rows = DRIVE.read_text().splitlines()
    kept = [row for row in rows[1:] if float(row.partition(",")[0]) <= SECONDS]
    (folder / "drive.csv").write_text("\n".join([rows[0], *kept]) + "\n")
    return folder


def carried(drive: Path, built: Path, programs: list[list[str]], before: list[str], environment: dict[str, str]):
    """Outputs of functions while the gateway carries the log to them, in a shell that ends them; by name."""
    recorded, gateway = drive / "recorded.csv", [sys.executable, "-m", "sigcat.cli", "gateway"]
    gateway += [str(drive / "drive.log"), "--dbc", str(CAN / "ecocontrol.dbc"), "-l", str(CAN / "can.vspec")]
    gateway += [
        "--add",
        str(drive / "drive.csv"),
        "--to",
        str(built / "integration.json"),
        "--keep",
        str(drive / built.name),
    ]
    gateway += ["--lock-step", "--recorded", str(recorded)]
    started = "".join(f'{shlex.join(each)} & pids="$pids $!"\n' for each in programs)
    script = f"{started}{shlex.join(gateway)}\nstatus=$?\nkill $pids\nwait\nexit $status\n"
    done = subprocess.run(
        [*before, "sh", "-c", script], env=environment, check=False, capture_output=True, text=True, timeout=900
    )
    assert done.returncode == 0, done.stderr
    assert "values of 12 signals sent over" in done.stderr
    with recorded.open(newline="") as file, (drive / "by_name.csv").open("w", newline="") as long:
        writer = csv.writer(long)
        for row in csv.DictReader(file):
            time = nanoseconds(row.pop("time"))
            writer.writerows((time, name, text) for name, text in row.items() if text)
    return dict(read_recorded(drive / "by_name.csv", subject().prepared.columns))


def simulated(drive: Path, folder: Path):
    runner = RUNNERS["simulate"]
    end = nanoseconds((drive / "drive.csv").read_text().splitlines()[-1].partition(",")[0])
    assert end is not None
    return dict(
        runner.play(runner.build(subject(), folder, toolchain()), subject(), Drive(drive / "drive.csv", end)).sent
    )


@needs.cmake
@needs.own_network
def test_applications_of_autosar_adaptive_get_what_comes_from_can(drive, tmp_path):
    built = RUNNERS["autosar-adaptive"].build(subject(), tmp_path / "autosar", toolchain()).folder
    programs = [[str(built / "build" / name / name)] for name in ("CoreAccExecutable", "EcoControlMpcExecutable")]
    before = [*(own_network() or ()), "sh", "-c", f'{shlex.join([sys.executable, "-c", LOOPBACK_UP])}; exec "$@"', "sh"]
    found = carried(drive, built, programs, before, {**os.environ, "BENCH_PLAYER": "40000"})
    expected = {name: each for name, each in simulated(drive, tmp_path).items() if not name.endswith("_SftyCondSts")}
    both = [{name: changes(name, values) for name, values in sent.items()} for sent in (expected, found)]
    behaviour = in_lock_step(*both)
    assert behaviour.is_equal
    assert behaviour.values > 1000


@needs.ros2
def test_nodes_of_ros2_get_what_comes_from_can(drive, tmp_path):
    built = RUNNERS["ros2-cpp"].build(subject(), tmp_path / "ros2", toolchain()).folder
    domain = {"ROS_DOMAIN_ID": "93", "ROS_AUTOMATIC_DISCOVERY_RANGE": "LOCALHOST"}
    own = {**installed().variables(built / "install", built / "subset/install"), **domain}
    names = ("PATH", "AMENT_PREFIX_PATH", "LD_LIBRARY_PATH", "_ROS_WHEELS_BOOTSTRAP_COMPLETE", *domain)
    variables = ["env", *(f"{name}={own[name]}" for name in names if name in own), f"ROS_HOME={tmp_path}"]
    programs = [
        [*variables, str(built / "install/lib/eco_control" / name), "--ros-args", "-p", "lock_step:=true"]
        for name in ("core_acc_node", "eco_control_mpc_node")
    ]
    found = carried(drive, built, programs, [], {**os.environ, **domain})
    behaviour = in_lock_step(simulated(drive, tmp_path), found)
    assert behaviour.is_equal
    assert behaviour.values > 1000
