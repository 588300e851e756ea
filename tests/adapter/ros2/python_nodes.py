"""The package in Python, installed; its nodes as processes, and another process that sends requests, in a separate domain."""

import fcntl
import json
import signal
import subprocess
import tempfile
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from scripts import ros2_environment
from scripts.ros2_packages import build_python, run
from tests.adapter.ros2.generated import write
from tests.adapter.ros2.loopback import LOOPBACK

PEER = Path(__file__).parent / "peer.py"
PATIENCE = 60.0
STRICT = ("-Wall", "-Wextra", "-Wpedantic", "-Wshadow", "-Wconversion", "-Werror", "-ffp-contract=off", "-O1")


class Installed(NamedTuple):
    """Folders where packages are installed: messages, and what is over them."""

    prefix: Path
    messages: Path

    @property
    def source(self) -> Path:
        """Folder of the installed files."""
        return self.prefix.parent / "source"


def install(
    made: Mapping[str, str], name: str, code: Mapping[str, tuple[str, Path]], messages: Path, folder: Path
) -> Installed:
    """Build cores, and install the package in Python over messages that are there.

    `code` has the node and the folder of each function. The nodes in C++ are left out: they need rclcpp.
    """
    source, prefix = write(made, folder / "source"), folder / "install"
    for function, (node, sources) in code.items():
        build_core(source / name / "core", function, sources, prefix / f"lib/lib{name}_{node}_core.so")
    index = prefix / "share/ament_index/resource_index/packages"
    index.mkdir(parents=True, exist_ok=True)
    (index / name).touch()
    return Installed(build_python(source / f"{name}_py", folder, prefix, messages), messages)


def build_core(core: Path, function: str, code: Path, library: Path) -> None:
    """Compile a core with its bridge and the code of its function; a warning is an error."""
    library.parent.mkdir(parents=True, exist_ok=True)
    sources = [*sorted(core.glob(f"{function}_*.c")), core / "sigcat_core.c", *sorted(code.glob("*.c"))]
    command = ["gcc", "-std=c99", "-shared", "-fPIC", *STRICT, f"-I{core}", f"-I{code}", *sources, "-lm", "-o", library]
    run(command, ros2_environment.variables())


@cache
def domain() -> tuple[int, Any]:
    """A domain that no other process of these tests has, and the lock that says so."""
    for number in range(20, 100):
        lock = (Path(tempfile.gettempdir()) / f"sigcat_ros_domain_{number}").open("w")
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError:
            lock.close()
        else:
            return number, lock
    raise RuntimeError("All domains are taken")


def variables(where: Installed, folder: Path) -> Mapping[str, str]:
    """Environment of a process that talks to those of this test alone."""
    own = {"ROS_DOMAIN_ID": str(domain()[0]), "ROS_LOG_DIR": str(folder), "HOME": str(folder)}
    return {**ros2_environment.variables(*where), **LOOPBACK, **own, "RMW_IMPLEMENTATION": "rmw_fastrtps_cpp"}


class Node:
    """A node in a separate process."""

    def __init__(
        self, where: Installed, package: str, executable: str, settings: Mapping[str, object], folder: Path
    ) -> None:
        given = [part for name, value in settings.items() for part in ("-p", f"{name}:={json.dumps(value)}")]
        self.said = folder / f"{executable}.txt"
        with self.said.open("a") as file:
            self.process = subprocess.Popen(
                [ros2_environment.PYTHON, where.prefix / "lib" / package / executable, "--ros-args", *given],
                env=variables(where, folder), stdout=file, stderr=file,
            )  # fmt: skip

    def is_alive(self) -> bool:
        """Whether it runs."""
        return self.process.poll() is None

    def end(self, how: int = signal.SIGINT) -> int:
        """End it, and answer how it has ended."""
        if self.is_alive():
            self.process.send_signal(how)
        return self.process.wait(PATIENCE)

    def leave(self) -> None:
        """End it so that the others know; if it does not end, without."""
        try:
            self.end()
        except subprocess.TimeoutExpired:
            self.end(signal.SIGKILL)


class Peer:
    """The other process."""

    def __init__(self, where: Installed, folder: Path) -> None:
        self.process = subprocess.Popen(
            [ros2_environment.PYTHON, PEER], env=variables(where, folder),
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True,
        )  # fmt: skip
        self._answer()

    def __call__(self, name: str, *arguments: Any) -> Any:
        """Ask it for something."""
        assert self.process.stdin is not None
        self.process.stdin.write(json.dumps([name, *arguments]) + "\n")
        self.process.stdin.flush()
        return self._answer()

    def _answer(self) -> Any:
        assert self.process.stdout is not None
        line = self.process.stdout.readline()
        assert line, "The peer has ended; its errors are above"
        return json.loads(line)

    def end(self) -> None:
        """End it."""
        assert self.process.stdin is not None
        self.process.stdin.close()
        self.process.wait(PATIENCE)


@contextmanager
def peer(where: Installed, folder: Path) -> Iterator[Peer]:
    """The other process, while it is needed."""
    made = Peer(where, folder)
    try:
        yield made
    finally:
        made.end()


@contextmanager
def started(where: Installed, package: str, executable: str, folder: Path, **settings: object) -> Iterator[Node]:
    """A node, while it is needed."""
    node = Node(where, package, executable, {"storage_folder": str(folder / "kept"), **settings}, folder)
    try:
        yield node
    finally:
        node.leave()
