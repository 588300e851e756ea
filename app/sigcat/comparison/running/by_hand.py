"""ROS 2 nodes that people wrote, with the topics of a set: what generated nodes are measured against.

They are built beside the generated ones, whose messages they use, and played to as these are.
"""

import time
from functools import partial
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as ET

from sigcat.comparison.recording import Built, Recording
from sigcat.comparison.running import ros2
from sigcat.comparison.running.runner import Drive, Subject
from sigcat.players.commands import BuildFails
from sigcat.players.ros2_environment import installed
from sigcat.players.ros2_packages import build_cmake

NAME, TITLE = "baseline", "ROS 2, by hand"


def build(package: Path, beside: Built, subject: Subject) -> Built:
    """Compile a package where the generated ones were built. Raises BuildFails."""
    found, folder = installed(), beside.folder
    begin = time.monotonic()
    others = [folder / "subset/install"] if found.rclcpp else []
    build_cmake(package.absolute(), folder, folder / "install", found, *others, settings=subject.code_settings)
    return Built(NAME, folder, (), 0.0, time.monotonic() - begin, beside.notes)


def play(package: Path, built: Built, subject: Subject, drive: Drive) -> Recording:
    """Play to the nodes written by hand: each is an executable with the name of the generated one."""
    name = _name(package)
    return ros2.play_nodes(built, subject, drive, partial(_files, package=name))


def _files(node: Any, folder: Path, *, package: str) -> tuple[Path, ...]:
    return (folder / "install/lib" / package / node["Executable"],)


def _name(package: Path) -> str:
    try:
        name = ET.parse(package / "package.xml").findtext("name")  # noqa: S314 - a file of the set, as its code is
    except (OSError, ET.ParseError) as error:
        raise BuildFails(f"{package / 'package.xml'}: {error}") from error
    return name or ""


def written_files(package: Path) -> list[Path]:
    """Return the files written by hand, without those that only measure."""
    kinds = {".cpp", ".hpp", ".c", ".h", ".xml", ".txt"}
    return [each for each in sorted(package.rglob("*")) if each.suffix in kinds and each.stem != "measuring"]
