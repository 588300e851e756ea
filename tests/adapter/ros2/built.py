"""EcoControl as packages of ROS 2, built once for as long as nothing of them changes."""

import fcntl
import hashlib
import json
import os
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import cache
from pathlib import Path

from scripts import ros2_environment, ros2_packages, run_ros2
from scripts.run_autosar import CODE
from sigcat.players.ros2_domain import own_domain
from sigcat.players.ros2_player_source import player_files
from tests.adapter.ros2.generated import ecocontrol, write
from tests.adapter.ros2.loopback import LOOPBACK
from tests.adapter.ros2.other_end import Peer, peer
from tests.needs import sampled

NODES = {"core_acc": "core_acc_node", "eco_control_mpc": "eco_control_mpc_node"}
LANGUAGES = {"C++": "eco_control", "Python": "eco_control_py"}
USUAL = sampled(LANGUAGES, usual=("C++",))
"""Python nodes have separate tests; in `make slow` they also run the tests of C++ nodes."""
FLAGS = "-O0 -Werror"
_MAKERS = (ros2_environment.REQUIREMENTS, Path(ros2_packages.__file__))
Made = Callable[[], Mapping[str, str]]
"""Function that returns the files of a workspace, by name."""
DAY = 24 * 3600
"""Seconds after which what was built and not used again is removed."""


@cache
def subset() -> Path:
    """The subset of rclcpp."""
    folder = _kept("subset", _of_files(ros2_packages.SUBSET, *_MAKERS))
    with _alone(folder) as is_new:
        if is_new:
            ros2_packages.build_subset(folder)
    return folder / "install"


@cache
def interfaces() -> Path:
    """Messages and services."""
    files = {name: text for name, text in ecocontrol().items() if "_interfaces/" in name}
    folder = _kept("interfaces", repr(files) + _of_files(*_MAKERS))
    with _alone(folder) as is_new:
        if is_new:
            write(files, folder / "src")
            run_ros2.build(folder)
    return folder / "install"


@cache
def workspace(made: Made = ecocontrol) -> run_ros2.Workspace:
    """The nodes in both languages. Files that are made otherwise have the same messages."""
    files = {name: text for name, text in made().items() if "_interfaces/" not in name}
    others = (interfaces(), subset())
    folder = _kept("ecocontrol", repr((files, others)) + _of_files(*CODE.values(), *_MAKERS))
    with _alone(folder) as is_new:
        if is_new:
            write(files, folder / "src")
            run_ros2.build(folder, *others, flags=FLAGS)
    return run_ros2.Workspace(folder / "install", others)


@cache
def player() -> Path:
    """The program that plays the drive."""
    files = player_files(json.loads(run_ros2.INTEGRATION.read_bytes()))
    folder = _kept("player", repr((files, interfaces(), subset())) + _of_files(*_MAKERS))
    with _alone(folder) as is_new:
        if is_new:
            run_ros2.build_player(folder, interfaces(), subset())
    return folder / "install/lib/player/player"


def _of_files(*roots: Path) -> str:
    files = [
        file for root in roots for file in (sorted(root.rglob("*")) if root.is_dir() else [root]) if file.is_file()
    ]
    return hashlib.sha256(b"".join(file.read_bytes() for file in files)).hexdigest()


def _kept(name: str, made_of: str) -> Path:
    """A folder that only what is made of the same has, in the same environment by the same name: CMake writes that down."""
    digest = hashlib.sha256((made_of + str(ros2_environment.ENVIRONMENT)).encode()).hexdigest()
    folders = f"sigcat-ros2-{os.getuid()}-{name}"
    folder = Path(tempfile.gettempdir()) / f"{folders}-{digest[:16]}"
    folder.mkdir(exist_ok=True)
    (folder / "lock").touch()
    for lock in folder.parent.glob(f"{folders}-*/lock"):
        if time.time() - lock.stat().st_mtime > DAY:
            shutil.rmtree(lock.parent, ignore_errors=True)
    return folder


@contextmanager
def _alone(folder: Path) -> Iterator[bool]:
    """Other workers of pytest-xdist wait, and find it built."""
    with (folder / "lock").open("r+") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        done = folder / "done"
        yield not done.exists()
        done.touch()


def variables(built: run_ros2.Workspace, number: int, folder: Path) -> Mapping[str, str]:
    """Environment of processes of a domain."""
    return {**run_ros2.environment(built, number, folder), **LOOPBACK}


def preloaded(source: str, folder: Path) -> Path:
    """A library in C++ for LD_PRELOAD."""
    library = folder / "preloaded.so"
    command = ["g++", "-shared", "-fPIC", "-x", "c++", "-", "-o", str(library)]
    subprocess.run(command, input=source, text=True, check=True)
    return library


@contextmanager
def running(
    language: str, folder: Path, *nodes: str, arguments: tuple[str, ...] = (), made: Made = ecocontrol
) -> Iterator[Peer]:
    """Nodes in separate processes, and a peer at the other end of their topics and services."""
    built = workspace(made)
    executables = [built.prefix / "lib" / LANGUAGES[language] / NODES[node] for node in nodes]
    with own_domain() as number:
        own = variables(built, number, folder)
        commands = [(executable, "--ros-args", *arguments) for executable in executables]
        with run_ros2.started(commands, own, folder / "nodes.txt"), peer(own) as other:
            yield other


def ended(language: str, folder: Path, node: str, *arguments: str) -> tuple[int, str]:
    """Return how a short-lived node ends, and its output."""
    built = workspace()
    executable = built.prefix / "lib" / LANGUAGES[language] / NODES[node]
    with own_domain() as number:
        return run_ros2.ended([executable, "--ros-args", *arguments], variables(built, number, folder))
