"""Builds ROS 2 packages for tests, as `sigcat compare` does, with what `make ros2` has made.

What rclcpp gives comes from the subset in tests/adapter/ros2/rclcpp_subset.
"""

from collections.abc import Mapping
from pathlib import Path

from scripts import ros2_environment
from sigcat.players import ros2_packages
from sigcat.players.commands import ran as run
from sigcat.players.ros2_environment import SUBSET, Ros2

__all__ = ["SUBSET", "build_cmake", "build_python", "build_subset", "run"]


def build_subset(folder: Path) -> Path:
    """The subset of rclcpp; the folder where it was installed."""
    return build_cmake(SUBSET, folder, folder / "install")


def build_cmake(
    source: Path,
    folder: Path,
    prefix: Path,
    *others: Path,
    flags: str = "",
    settings: Mapping[str, object] | None = None,
) -> Path:
    """Build and install into a prefix. The package finds others there, and in those that are named."""
    own = {"CMAKE_CXX_FLAGS": flags, **(settings or {})}
    return ros2_packages.build_cmake(source, folder, prefix, _ros2(), *others, settings=own)


def build_python(source: Path, folder: Path, prefix: Path, *others: Path) -> Path:
    """Install a package of Python, as colcon does."""
    return ros2_packages.build_python(source, folder, prefix, _ros2(), *others)


def _ros2() -> Ros2:
    environment = ros2_environment.ENVIRONMENT
    return Ros2(ros2_environment.PYTHON, (environment,), environment, SUBSET)
