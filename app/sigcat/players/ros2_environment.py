"""Place of ROS 2: the sourced one, else that of a checkout of sigcat, which has our subset of rclcpp."""

import os
import shutil
import subprocess
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import NamedTuple

from sigcat.players.commands import BuildFails

_CHECKOUT = Path(__file__).parents[3]
WHEELS = _CHECKOUT / ".venv-ros2"
"""Result of `make ros2`."""
SUBSET = _CHECKOUT / "tests/adapter/ros2/rclcpp_subset"
_LINKER = (
    "-Wl,--as-needed,--unresolved-symbols=ignore-in-shared-libs "
    "-Wl,--push-state,--no-as-needed {library} -Wl,--pop-state"
)
"""Libraries of messages for Python leave its symbols to the interpreter, which a program in C++ has to link."""
_LIBRARIES = (
    "import sysconfig; print(sysconfig.get_config_var('LIBDIR'), sysconfig.get_config_var('MULTIARCH'), sep='\\n')"
)
_FOREIGN = ("PYTHON", "ROS_", "RMW_", "VIRTUAL_ENV")


class Ros2(NamedTuple):
    """An installed ROS 2."""

    python: Path
    """The interpreter that has rclpy."""
    prefixes: tuple[Path, ...]
    wheels: Path | None = None
    """The environment of a checkout; None: ROS 2 was sourced, and its variables are there."""
    rclcpp: Path | None = None
    """Source to build in place of rclcpp."""

    @property
    def note(self) -> str:
        """Parts that are not of ROS 2."""
        return "rclcpp: sigcat's subset of rclcpp 28, on the real rcl and rmw" if self.rclcpp else ""

    @property
    def linker_flags(self) -> str:
        """Libraries of executables."""
        return _LINKER.format(library=python_library(self.python)) if self.wheels else ""

    def variables(self, *prefixes: Path) -> Mapping[str, str]:
        """Environment of a process that uses it, and what was installed into these folders, the first before the others."""
        if self.wheels is not None:
            return variables_of_wheels(self.wheels, *prefixes)
        folders = {
            "AMENT_PREFIX_PATH": prefixes,
            "CMAKE_PREFIX_PATH": prefixes,
            "LD_LIBRARY_PATH": [each / "lib" for each in prefixes],
            "PYTHONPATH": [site for each in prefixes for site in each.glob("**/*-packages") if site.is_dir()],
        }
        return {**os.environ, **{name: _joined((*own, *_known(name))) for name, own in folders.items()}}


def find_ros2(environment: Mapping[str, str]) -> Ros2 | str:
    """ROS 2, or one line that says how to get it."""
    prefixes = [Path(each) for each in environment.get("AMENT_PREFIX_PATH", "").split(os.pathsep) if each]
    path = environment.get("PATH")
    if any((each / "share/rclpy").is_dir() for each in prefixes):
        if not any((each / "share/rclcpp").is_dir() for each in prefixes):
            return "the sourced ROS 2 has no rclcpp: apt-get install ros-$ROS_DISTRO-rclcpp-lifecycle ros-$ROS_DISTRO-rclcpp-components"
        return Ros2(Path(shutil.which("python3", path=path) or "python3"), tuple(prefixes))
    if (WHEELS / "made_of").is_file() and SUBSET.is_dir():
        return Ros2(WHEELS / "bin/python", (WHEELS,), WHEELS, SUBSET)
    if SUBSET.is_dir():
        return "ROS 2 is not there: source its setup.bash, or run `make ros2`"
    return "ROS 2 is not there: install it (https://docs.ros.org), and source its setup.bash"


def installed() -> Ros2:
    """The ROS 2 that is built with. Raises BuildFails if there is none."""
    found = find_ros2(os.environ)
    if isinstance(found, str):
        raise BuildFails(found)
    return found


def variables_of_wheels(wheels: Path, *prefixes: Path) -> Mapping[str, str]:
    """Environment of a process that uses the wheels of ROS 2, and what was installed into these folders."""
    kept = {name: value for name, value in os.environ.items() if not name.startswith(_FOREIGN)}
    roots = (*prefixes, wheels)
    packages = wheels / "lib/python3.11/site-packages"
    python = python_library(wheels / "bin/python").parent
    return {
        **kept,
        "PATH": _joined((wheels / "bin", *kept.get("PATH", "").split(os.pathsep))),
        "AMENT_PREFIX_PATH": _joined(roots),
        "CMAKE_PREFIX_PATH": _joined(roots),
        "LD_LIBRARY_PATH": _joined((*(root / "lib" for root in roots), *packages.glob("ros_*.libs"), python)),
        "PYTHONPATH": _joined(prefix / "lib/python3.11/site-packages" for prefix in prefixes),
        "_ROS_WHEELS_BOOTSTRAP_COMPLETE": "1",
    }


def python_library(python: Path) -> Path:
    """The interpreter as a shared library: libraries of messages leave its symbols to the program that loads them."""
    told = subprocess.run([python, "-c", _LIBRARIES], check=True, capture_output=True, text=True).stdout  # noqa: S603
    folder, architecture = told.splitlines()
    places = (Path(folder, "libpython3.11.so"), Path("/usr/lib", architecture, "libpython3.11.so"))
    return next(path for path in places if path.exists())


def _known(name: str) -> Iterable[str]:
    return filter(None, os.environ.get(name, "").split(os.pathsep))


def _joined(paths: Iterable[Path | str]) -> str:
    return os.pathsep.join(map(str, paths))
