"""EcoControl as ROS 2 nodes: `make run-ros2`, or `python -m scripts.run_ros2 [SECONDS]`.

Generates the packages, builds them with real rosidl and our subset of rclcpp, plays the recorded drive in lock step to the nodes
in C++ and then to those in Python, and holds what they send against `sigcat simulate`.
"""

import json
import signal
import subprocess
import sys
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import NamedTuple

from scripts import recordings, ros2_environment, ros2_packages
from scripts.recordings import EXAMPLES, WHOLE_DRIVE, Sent, bits
from scripts.run_autosar import CODE
from sigcat.players.commands import write
from sigcat.players.ros2_domain import own_domain, variables_in_domain
from sigcat.players.ros2_player_source import player_files

INTEGRATION = EXAMPLES / "ecocontrol/expected/ros2.json"
NODES = ("core_acc_node", "eco_control_mpc_node")
PACKAGES = {"C++": "eco_control", "Python": "eco_control_py"}
LOCK_STEP = ("--ros-args", "-p", "lock_step:=true")
PATIENCE = 60
"""Seconds in which a process has to end."""


class Workspace(NamedTuple):
    """Folders in which the built packages are installed."""

    prefix: Path
    others: tuple[Path, ...]
    """Environment of the packages that it builds on."""


def main() -> int:
    """Exit status 0 if everything that was sent is what the simulation sends."""
    seconds = int(sys.argv[1]) if len(sys.argv) > 1 else WHOLE_DRIVE
    ros2_environment.make()
    folder = ros2_environment.HERE / "build/ros2"
    generate_into(folder / "src")
    workspace = build(folder, ros2_packages.build_subset(folder / "subset"))
    player = build_player(folder / "player", workspace.prefix, *workspace.others)
    expected = recordings.simulated(folder / "simulated.csv", seconds)
    is_wrong = False
    for language, package in PACKAGES.items():
        sent = play(workspace, player, package, folder / package, seconds)
        wrong = differences(sent, expected)
        is_wrong |= bool(wrong)
        print(f"{language}: {seconds} s, {sum(map(len, sent.values()))} values over DDS, none lost")
        print("\n".join(wrong) or "bit for bit what `sigcat simulate` sends", flush=True)
    return 1 if is_wrong else 0


def generate_into(folder: Path, integration: Path = INTEGRATION) -> None:
    """Write the packages."""
    from sigcat.adapter.ros2.ros2_workspace import generate
    from sigcat.limits import DEFAULT_LIMITS

    write(generate(integration.read_bytes(), str(integration), DEFAULT_LIMITS, None), folder)


def build(folder: Path, *others: Path, flags: str = "", code: Mapping[str, Path] = CODE) -> Workspace:
    """Build the packages of `folder/src`, messages first, and install all of them into one place."""
    prefix = folder / "install"
    settings = {**code, "CMAKE_BUILD_TYPE": "None"}
    for package in sorted((folder / "src").iterdir(), key=lambda path: not path.name.endswith("_interfaces")):
        if (package / "CMakeLists.txt").exists():
            own = settings if (package / "src").exists() else {}
            ros2_packages.build_cmake(package, folder, prefix, *others, flags=flags if own else "", settings=own)
        elif (package / "setup.py").exists():
            ros2_packages.build_python(package, folder, prefix, *others)
    return Workspace(prefix, others)


def build_player(folder: Path, *others: Path) -> Path:
    """Build the player, with what it is built on, and return its program."""
    write(player_files(json.loads(INTEGRATION.read_bytes())), folder / "source")
    return ros2_packages.build_cmake(folder / "source", folder, folder / "install", *others) / "lib/player/player"


def environment(workspace: Workspace, number: int, home: Path) -> Mapping[str, str]:
    """That of processes of a domain, which keep their files in a folder and stay on this machine."""
    return {
        **ros2_environment.variables(workspace.prefix, *workspace.others),
        **variables_in_domain(number, home),
    }


@contextmanager
def started(commands: Sequence[Sequence[object]], variables: Mapping[str, str], told: Path) -> Iterator[None]:
    """Processes that run meanwhile, and end with status 0 on request; their output is in a file."""
    with told.open("a") as output, ExitStack() as stack:
        running = []
        for command in commands:
            words = [str(word) for word in command]
            process = subprocess.Popen(words, env=variables, stdout=output, stderr=output)
            stack.callback(process.kill)
            running.append(process)
        yield
        for process in running:
            process.send_signal(signal.SIGTERM)
        ends = [process.wait(PATIENCE) for process in running]
        if any(ends):
            raise RuntimeError(f"processes ended with {ends}\n{told.read_text()[-3000:]}")


def ended(command: Sequence[object], variables: Mapping[str, str]) -> tuple[int, str]:
    """Return how a short-lived process ends, and its output."""
    words = [str(word) for word in command]
    done = subprocess.run(words, env=variables, capture_output=True, text=True, check=False, timeout=2 * PATIENCE)
    return done.returncode, done.stdout + done.stderr


def play(workspace: Workspace, player: Path, package: str, folder: Path, seconds: int) -> Sent:
    """Return the values that the nodes send while the drive is played to them in lock step."""
    folder.mkdir(parents=True, exist_ok=True)
    recording = folder / "recorded.csv"
    executables = [workspace.prefix / "lib" / package / node for node in NODES]
    trace = recordings.normalized(folder / "normalized.tsv")
    command = [player, "lock", trace, recording, seconds * 10**9]
    with own_domain() as number:
        variables = environment(workspace, number, folder)
        with started([(each, *LOCK_STEP) for each in executables], variables, folder / "nodes.txt"):
            ros2_packages.run(command, variables)
    return recordings.recorded(recording)


def differences(sent: Sent, expected: Sent) -> list[str]:
    """List values that differ from the expected ones, bit for bit."""
    found = []
    for name in sorted({*sent, *expected}):
        both = [[(time, bits(value)) for time, value in each.get(name, [])] for each in (sent, expected)]
        if both[0] != both[1]:
            first = next((pair for pair in zip(*both, strict=False) if pair[0] != pair[1]), "one is longer")
            found.append(f"{name}: {len(both[0])} values, not {len(both[1])}; {first}")
    return found


if __name__ == "__main__":
    sys.exit(main())
