"""Real ROS 2 Jazzy for tests, in `.venv-ros2`: `make ros2`. A second run with nothing new does nothing.

PyPI has it without rclcpp, for CPython 3.11 alone. Its CMake files name folders of the machine where the wheels were built:
they are rewritten to those of the environment.
"""

import hashlib
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from shutil import rmtree, which

HERE = Path(__file__).parents[1]
ENVIRONMENT = HERE / ".venv-ros2"
REQUIREMENTS = HERE / "requirements-ros2.txt"
PYTHON = ENVIRONMENT / "bin/python"
_PACKAGES = ENVIRONMENT / "lib/python3.11/site-packages"
_MADE = ENVIRONMENT / "made_of"
_VERSION = "import sys; sys.exit(sys.version_info[:2] != (3, 11))"
_INCLUDES = "import sysconfig, numpy; print(sysconfig.get_path('include'), numpy.get_include(), sep='\\n')"
_LIBRARIES = (
    "import sysconfig; print(sysconfig.get_config_var('LIBDIR'), sysconfig.get_config_var('MULTIARCH'), sep='\\n')"
)
_COMMANDS = {"cmake": "cmake", "ninja": "ninja-build", "g++": "g++"}
"""Commands that build packages, and the Debian packages that contain them."""


class CannotBeMade(Exception):
    """Name missing commands, and how to get them."""


def main() -> int:
    """Make the environment. Exit status 1 if something is missing for it."""
    try:
        make()
    except CannotBeMade as error:
        print(f"{ENVIRONMENT.name} cannot be made: {error}", file=sys.stderr)
        return 1
    return 0


def make() -> None:
    """Install, rewrite, and note what it was made of."""
    if is_made():
        return
    base = _python()
    _check_machine(base)
    rmtree(ENVIRONMENT, ignore_errors=True)
    _run(base, "-m", "venv", str(ENVIRONMENT))
    _run(str(PYTHON), "-m", "pip", "--quiet", "--disable-pip-version-check", "install", "-r", str(REQUIREMENTS))
    _rewrite()
    _MADE.write_text(_digest())


def is_made() -> bool:
    """Whether it is there, and of today's list."""
    return _MADE.is_file() and _MADE.read_text() == _digest()


def _digest() -> str:
    return hashlib.sha256(REQUIREMENTS.read_bytes()).hexdigest()


def _python() -> str:
    """The interpreter of the environment."""
    for command in (sys.executable, which("python3.11")):
        if command and subprocess.run([command, "-c", _VERSION], check=False).returncode == 0:
            return command
    raise CannotBeMade(
        f"the wheels of ROS 2 are for Python 3.11, and this is {sys.version.split()[0]}: put python3.11 on the path"
    )


def _check_machine(base: str) -> None:
    """Install the parts that no wheel has."""
    missing = [package for command, package in _COMMANDS.items() if not which(command)]
    if not _library_of(base):
        missing.append("libpython3.11-dev")
    if missing:
        raise CannotBeMade(f"something is missing: apt-get install {' '.join(missing)}")


def _run(*command: str) -> None:
    done = subprocess.run(command, check=False, stderr=subprocess.PIPE, text=True)
    if done.returncode:
        raise CannotBeMade(f"`{' '.join(command)}` failed.\n{done.stderr[-3000:]}")


def _rewrite() -> None:
    """Folders of the machine where the wheels were built become the environment's."""
    include, numpy = _asked(str(PYTHON), _INCLUDES)
    (tinyxml,) = (_PACKAGES / "ros_fastrtps.libs").glob("libtinyxml2-*.so*")
    folders = {
        "/opt/python/cp311-cp311/lib/python3.11/site-packages/numpy/_core/include": numpy,
        "/opt/python/cp311-cp311/include/python3.11": include,
        "/usr/lib64/libtinyxml2.so": str(tinyxml),
    }
    for file in (ENVIRONMENT / "share").rglob("*.cmake"):
        _replace(file, folders)


def _replace(file: Path, texts: Mapping[str, str]) -> None:
    old = new = file.read_text(encoding="utf-8")
    for text, replacement in texts.items():
        new = new.replace(text, replacement)
    if new != old:
        file.write_text(new, encoding="utf-8")


def _asked(python: str, question: str) -> Sequence[str]:
    return subprocess.run([python, "-c", question], check=True, capture_output=True, text=True).stdout.splitlines()


def _library_of(python: str) -> Path | None:
    folder, architecture = _asked(python, _LIBRARIES)
    for path in (Path(folder, "libpython3.11.so"), Path("/usr/lib", architecture, "libpython3.11.so")):
        if path.exists():
            return path
    return None


def variables(*prefixes: Path) -> Mapping[str, str]:
    """Environment of a process that uses it, and what was installed into these folders, the first before the others."""
    from sigcat.players.ros2_environment import variables_of_wheels  # who makes it has no sigcat yet

    return variables_of_wheels(ENVIRONMENT, *prefixes)


if __name__ == "__main__":
    sys.exit(main())
