"""Builds ROS 2 packages as their users do, without colcon: configured, built and installed with CMake, or with setup.py."""

from collections.abc import Mapping
from pathlib import Path

from sigcat.players import cmake
from sigcat.players.commands import ran
from sigcat.players.ros2_environment import Ros2

UNITED = Path(__file__).with_name("united.cmake")
"""Included in a project of messages: few large translation units instead of many small ones."""


def build_cmake(
    source: Path, folder: Path, prefix: Path, ros2: Ros2, *others: Path, settings: Mapping[str, object] | None = None
) -> Path:
    """Build and install into a prefix. The package finds others there, and in those that are named."""
    cache = {
        "CMAKE_INSTALL_PREFIX": prefix,
        "CMAKE_EXE_LINKER_FLAGS": ros2.linker_flags,
        "Python3_EXECUTABLE": ros2.python,
        "BUILD_TESTING": "OFF",
        **({"Python3_FIND_VIRTUALENV": "ONLY"} if ros2.wheels else {}),
        **(settings or {}),
    }
    environment = ros2.variables(prefix, *others)
    cmake.build(source, folder / "build" / source.name, cache, "-G", "Ninja", target="install", environment=environment)
    return prefix


def build_python(source: Path, folder: Path, prefix: Path, ros2: Ros2, *others: Path) -> Path:
    """Install a package of Python, as colcon does."""
    build = folder / "build" / source.name
    build.mkdir(parents=True, exist_ok=True)
    files = ["--record", build / "installed.txt", "--single-version-externally-managed"]
    command = [ros2.python, "setup.py", "--quiet", "egg_info", "--egg-base", build]
    install = ["build", "--build-base", build, "install", "--prefix", prefix, *files]
    ran([*command, *install], ros2.variables(prefix, *others), source)
    return prefix
