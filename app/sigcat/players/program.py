"""The player of an Integration JSON is built, for whichever platform that is."""

import json
import os
import shutil
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Literal, NamedTuple

from sigcat import codes
from sigcat.adapter.autosar_adaptive.application.adaptive_application import generate_player
from sigcat.adapter.files import GeneratedFile
from sigcat.adapter.host.shapes import Shape
from sigcat.adapter.source_functions import source_functions
from sigcat.errors import UsageError
from sigcat.file_kind import document_kind
from sigcat.integration.autosar_adaptive.document import read_integration
from sigcat.integration.ros2.document import read_integration as read_ros2
from sigcat.limits import DEFAULT_LIMITS
from sigcat.platforms.platform import Options
from sigcat.platforms.ros2 import PACKAGES
from sigcat.players import cmake
from sigcat.players.commands import write
from sigcat.players.ros2_environment import Ros2, installed
from sigcat.players.ros2_packages import UNITED, build_cmake
from sigcat.players.ros2_player_source import player_files
from sigcat.runs.prepare import received_by

Mode = Literal["timed", "live", "lock"]
"""Rows are sent at their times, or when they come, or in lock step with functions that wait for them."""
_PORT = "BENCH_PLAYER"
_DEFAULT_PORT = "40000"
_OUT = "/dev/stdout"
_OF_DOMAIN = ("ROS_DOMAIN_ID", "ROS_AUTOMATIC_DISCOVERY_RANGE", "ROS_STATIC_PEERS", "RMW_IMPLEMENTATION")
"""Variables that say where nodes find each other."""


class Program(NamedTuple):
    """A player that is started with a mode, and takes rows from standard input."""

    platform: str
    """SOME/IP, or DDS."""
    player: Path
    environment: Mapping[str, str]
    received: Mapping[str, Shape]
    """Shapes of the values that the functions receive from outside, by name."""

    def command(self, mode: Mode) -> tuple[str, ...]:
        """Return the command that starts it."""
        if self.platform == "DDS":
            return (str(self.player), mode, "-", _OUT)
        return (str(self.player), "-", _OUT, *(("live",) if mode == "live" else ()))

    def variables(self, mode: Mode) -> Mapping[str, str]:
        """Its environment. At a port, the player of SOME/IP waits for applications that run in lock step."""
        rest = {name: value for name, value in self.environment.items() if name != _PORT}
        return {**rest, _PORT: os.environ.get(_PORT, _DEFAULT_PORT)} if mode == "lock" else rest


def build_player(data: bytes, name: str, folder: Path) -> Program:
    """Generate and build in a folder; what is there already is not built again.

    Raises InputRefused if the document cannot be used, UsageError if it is none, BuildFails if a tool says so or is not there.
    """
    if not shutil.which("cmake"):
        raise UsageError("--to builds a player with CMake: apt-get install cmake ninja-build g++")
    try:
        document = json.loads(data)
    except ValueError:
        document = None
    kind = document_kind(document.keys()) if isinstance(document, dict) else None
    build = _PLAYERS.get(kind.platform) if kind is not None else None
    if build is None:
        found = f"; it is {kind.title}" if kind is not None else ""
        wanted = " or ".join(f"`sigcat integrate {platform}`" for platform in _PLAYERS)
        raise UsageError(f"{name} must be Integration JSON, as {wanted} writes it{found}")
    return build(data, name, folder)


def _of_autosar(data: bytes, name: str, folder: Path) -> Program:
    functions = read_integration(data, name, DEFAULT_LIMITS).functions
    rule = codes.NOT_WRITABLE_AS_ARXML
    received = received_by(source_functions(functions, data, name, DEFAULT_LIMITS, rule, "autosar-adaptive"))
    write(generate_player(data, name, DEFAULT_LIMITS), folder)
    settings = {"CMAKE_UNITY_BUILD": "ON", "CMAKE_UNITY_BUILD_BATCH_SIZE": 100}
    cmake.build(folder, folder / "build", settings, target="player")
    return Program("SOME/IP", folder / "build/player/player", dict(os.environ), received)


def _of_ros2(data: bytes, name: str, folder: Path) -> Program:
    document = json.loads(data)
    files = PACKAGES.generate(data, name, DEFAULT_LIMITS, Options())
    functions = read_ros2(data, name, DEFAULT_LIMITS).functions
    received = received_by(source_functions(functions, data, name, DEFAULT_LIMITS, codes.NOT_WRITABLE_AS_ROS2, "ros2"))
    ros2, prefix = installed(), folder / "install"
    subset = [build_cmake(ros2.rclcpp, folder / "subset", folder / "subset/install", ros2)] if ros2.rclcpp else []
    messages = document["InterfacePackageList"][0]["Name"]
    write(_of_package(messages, files), folder / "src")
    build_cmake(folder / "src" / messages, folder, prefix, ros2, *subset, settings={"CMAKE_PROJECT_INCLUDE": UNITED})
    write(player_files(document), folder / "player")
    build_cmake(folder / "player", folder, prefix, ros2, *subset)
    return Program("DDS", prefix / "lib/player/player", _variables(ros2, prefix, *subset), received)


_PLAYERS: Mapping[str, Callable[[bytes, str, Path], Program]] = {"autosar-adaptive": _of_autosar, "ros2": _of_ros2}
"""Builders of players by the names of platforms."""


def _of_package(name: str, files: tuple[GeneratedFile, ...]) -> tuple[GeneratedFile, ...]:
    return tuple(file for file in files if file.name.startswith(f"{name}/"))


def _variables(ros2: Ros2, *prefixes: Path) -> Mapping[str, str]:
    domain = {name: value for name in _OF_DOMAIN if (value := os.environ.get(name))}
    return {**ros2.variables(*prefixes), **domain}
