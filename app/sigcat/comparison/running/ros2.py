"""ROS 2: lifecycle nodes in C++ or in Python, a process each, over DDS in a separate domain."""

import json
import shutil
import time
from collections.abc import Callable, Mapping
from functools import partial
from pathlib import Path
from typing import Any

from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.toolchain import Toolchain
from sigcat.comparison.recording import Built, Recording
from sigcat.comparison.running import marks
from sigcat.comparison.running.end_to_end import read_end_to_end
from sigcat.comparison.running.generated import generated
from sigcat.comparison.running.processes import Process, launched
from sigcat.comparison.running.recorded import begin_of, fresh_run, read_recorded, write_normalized
from sigcat.comparison.running.runner import Drive, Runner, Subject
from sigcat.comparison.running.slow_calls import durations, with_slow_calls
from sigcat.players.commands import write
from sigcat.players.ros2_domain import own_domain, variables_in_domain
from sigcat.players.ros2_environment import Ros2, find_ros2, installed
from sigcat.players.ros2_packages import UNITED, build_cmake, build_python
from sigcat.players.ros2_player_source import player_files

CPP, PYTHON = "ros2-cpp", "ros2-py"
_PLAYER = "install/lib/player/player"
_WORDS = {"lock step": "lock", "free run": "free"}
_LOCK_STEP = ("--ros-args", "-p", "lock_step:=true")


def _missing(environment: Mapping[str, str]) -> str | None:
    path = environment.get("PATH")
    if not shutil.which("cmake", path=path) or not shutil.which("ninja", path=path):
        return "ROS 2 nodes are built with CMake and Ninja: apt-get install cmake ninja-build g++"
    found = find_ros2(environment)
    return found if isinstance(found, str) else None


# -- building -----------------------------------------------------------------------------------------------------


def _build(subject: Subject, folder: Path, tools: Toolchain, *, language: str) -> Built:
    """Both languages share a folder: nodes in Python load the core that the package in C++ has."""
    del tools  # CMake finds its own, by the same variables
    ros2, made = installed(), generated(subject, "ros2")
    write(with_slow_calls(made.files, subject.prepared.connections.members), folder / "src")
    (folder / "integration.json").write_bytes(made.integration)
    begin = time.monotonic()
    subset = [_built_subset(ros2.rclcpp, folder / "subset", ros2)] if ros2.rclcpp else []
    measured = marks.cmake_settings(subject.prepared.connections.members, folder / "marks")
    prefix = folder / "install"
    for package in _packages(folder / "src"):
        if (package / "src").exists():
            own = {**subject.code_settings, **measured, "CMAKE_UNITY_BUILD": "ON"}
            build_cmake(package, folder, prefix, ros2, *subset, settings=own)
        elif (package / "CMakeLists.txt").exists():
            build_cmake(package, folder, prefix, ros2, *subset, settings={"CMAKE_PROJECT_INCLUDE": UNITED})
        elif language == PYTHON:
            build_python(package, folder, prefix, ros2, *subset)
    write(player_files(json.loads(made.integration)), folder / "player")
    build_cmake(folder / "player", folder, prefix, ros2, *subset)
    own_files = tuple(file for file in made.files if _is_of(language, file))
    notes = (ros2.note,) if ros2.note else ()
    return Built(language, folder, own_files, made.seconds, time.monotonic() - begin, notes)


def _built_subset(source: Path, folder: Path, ros2: Ros2) -> Path:
    """As a distribution has rclcpp: otherwise what is measured is a compiler that does not optimize."""
    return build_cmake(source, folder, folder / "install", ros2, settings={"CMAKE_BUILD_TYPE": "Release"})


def _packages(source: Path) -> list[Path]:
    """Messages first."""
    found = [each for each in source.iterdir() if (each / "package.xml").exists()]
    return sorted(found, key=lambda each: (not each.name.endswith("_interfaces"), each.name))


def _is_of(language: str, file: GeneratedFile) -> bool:
    """Whether a file runs with nodes of a language: the core is that of both."""
    package, _, path = file.name.partition("/")
    if package.endswith("_py"):
        return language == PYTHON
    return language == CPP or package.endswith("_interfaces") or path.startswith("core/")


# -- playing ------------------------------------------------------------------------------------------------------


Files = Callable[[Mapping[str, Any], Path], tuple[Path, ...]]
"""The program of a node, then what it loads that was built for it; in a folder where everything was built."""


def _play(built: Built, subject: Subject, drive: Drive, *, language: str) -> Recording:
    return play_nodes(built, subject, drive, partial(_files, language=language))


def play_nodes(built: Built, subject: Subject, drive: Drive, files: Files) -> Recording:
    """Play to nodes that have the topics and services of the set, generated or not."""
    ros2, folder = installed(), built.folder
    run = fresh_run(built, drive)
    document = json.loads((folder / "integration.json").read_bytes())
    recorded = run / "recorded.csv"
    kills = [f"{_node(document, each.function)['Executable']}@{each.function}@{each.time_ns}" for each in drive.kills]
    player = folder / _PLAYER
    normalized = write_normalized(drive.trace, subject.prepared, run / "normalized.tsv")
    command = (str(player), _WORDS[drive.mode], str(normalized), str(recorded), str(drive.end_ns), *kills)
    with own_domain() as number:
        environment = {
            **_variables(ros2, folder),
            **variables_in_domain(number, run),
            **_durations(drive, subject),
            marks.FOLDER: str(run / marks.NAME),
        }
        processes = [_process(node, files(node, folder), environment, drive) for node in _nodes(document)]
        outcome = launched(processes, Process("player", command, environment, (player,)), run)
    marked = marks.read_marks(subject.prepared.connections, run / marks.NAME, 0)
    sent = read_recorded(recorded, subject.prepared.columns)
    ages = read_end_to_end(recorded.with_name(f"{recorded.name}.times"), drive.trace, subject.prepared, marked.calls)
    return Recording(
        built.platform, drive.mode, built, sent, marked.calls, outcome.loads,
        last_words=outcome.last_words, play_s=outcome.seconds, end_to_end=ages, supervised=marked.supervised,
    )  # fmt: skip


def _durations(drive: Drive, subject: Subject) -> Mapping[str, str]:
    return durations(drive, subject.prepared, begin_of(drive.trace, subject.prepared))


def _files(node: Mapping[str, Any], folder: Path, *, language: str) -> tuple[Path, ...]:
    package = node["Package"] if language == CPP else f"{node['Package']}_py"
    program = folder / "install/lib" / package / node["Executable"]
    library = folder / f"install/lib/lib{node['Package']}_{node['NodeName']}_core.so"
    component = folder / f"install/lib/lib{node['Package']}_{node['NodeName']}_node_component.so"
    modules = folder.glob(f"install/lib/python3*/site-packages/{package}/*.py")
    return (program, library, *([component] if language == CPP else modules))


def _process(node: Mapping[str, Any], files: tuple[Path, ...], environment: Mapping[str, str], drive: Drive) -> Process:
    lock_step = _LOCK_STEP if drive.mode == "lock step" else ()
    return Process(node["Executable"], (str(files[0]), *lock_step), environment, files)


def _nodes(document: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    return [
        {**node, "Package": package["Name"]} for package in document["NodePackageList"] for node in package["Nodes"]
    ]


def _node(document: Mapping[str, Any], function: str) -> Mapping[str, Any]:
    return next(each for each in _nodes(document) if each["FunctionName"] == function)


def _variables(ros2: Ros2, folder: Path) -> Mapping[str, str]:
    subset = [folder / "subset/install"] if ros2.rclcpp else []
    return ros2.variables(folder / "install", *subset)


def _runner(language: str, title: str, *, is_interpreted: bool) -> Runner:
    return Runner(
        language, title, _missing, partial(_build, language=language), partial(_play, language=language),
        shared_folder="ros2", paper_platform="ROS 2", is_interpreted=is_interpreted, has_baseline=not is_interpreted,
    )  # fmt: skip


ROS2_CPP = _runner(CPP, "ROS 2, C++", is_interpreted=False)
ROS2_PY = _runner(PYTHON, "ROS 2, Python", is_interpreted=True)
