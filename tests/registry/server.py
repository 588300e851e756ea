"""A private PostgreSQL server on a socket, for as long as the tests run."""

import os
import pwd
import shutil
import signal
import subprocess
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from itertools import count
from pathlib import Path
from typing import Any

from sigcat.project.project import ServerUrl

_NUMBERS = count()


class Server:
    """A server that can be stopped and started again. A root user runs it as another one, as it asks for."""

    def __init__(self, programs: Path, folder: Path) -> None:
        self.programs, self.data, self.socket = programs, folder / "data", folder / "socket"
        self._user: dict[str, Any] = {}
        self._process: subprocess.Popen[bytes] | None = None
        self.socket.mkdir()
        if os.geteuid() == 0:
            user = pwd.getpwnam("nobody")
            self._user = {"user": user.pw_uid, "group": user.pw_gid, "extra_groups": []}
            for path in (folder, self.socket):
                os.chown(path, user.pw_uid, user.pw_gid)
        words = (
            "initdb",
            "-D",
            str(self.data),
            "-U",
            "sigcat",
            "--auth=trust",
            "-E",
            "UTF8",
            "--locale=C.UTF-8",
            "--no-sync",
        )
        self._run(*words)

    def _run(self, name: str, *arguments: str) -> bytes:
        words = [str(self.programs / name), *arguments]
        return bytes(subprocess.run(words, check=True, capture_output=True, cwd="/", **self._user).stdout)

    def start(self) -> None:
        """Start it, and wait until it answers."""
        words = [
            str(self.programs / "postgres"),
            "-D",
            str(self.data),
            "-k",
            str(self.socket),
            "-c",
            "listen_addresses=",
        ]
        self._process = subprocess.Popen(
            words, stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL, cwd="/", **self._user
        )
        for _ in range(600):
            ready = [str(self.programs / "pg_isready"), "-q", "-h", str(self.socket)]
            if subprocess.run(ready, check=False).returncode == 0:
                return
            time.sleep(0.05)
        raise TimeoutError("the server does not answer")

    def stop(self) -> None:
        """Stop it at once, as a crash does."""
        if self._process is not None:
            self._process.send_signal(signal.SIGQUIT)  # an immediate shutdown
            self._process.wait(60)
            self._process = None

    def kill(self) -> None:
        """Kill it and its processes, which have no time to write anything."""
        assert self._process is not None
        number = self._process.pid
        children = Path(f"/proc/{number}/task/{number}/children").read_text(encoding="ascii").split()
        for each in (number, *map(int, children)):
            with suppress(ProcessLookupError):
                os.kill(each, signal.SIGKILL)
        self._process.wait(60)
        while any(Path(f"/proc/{each}").exists() for each in children):
            time.sleep(0.01)
        self._process = None

    def new_database(self) -> ServerUrl:
        """The URL of a new, empty database."""
        name = f"registry{os.getpid()}_{next(_NUMBERS)}"
        self.run("createdb", name)
        return self.url(name)

    def url(self, name: str) -> ServerUrl:
        """The URL of a database."""
        return ServerUrl(f"postgresql://sigcat@/{name}?host={self.socket}")

    def run(self, program: str, *arguments: str) -> bytes:
        """Run a client program, and return its output."""
        return self._run(program, "-h", str(self.socket), "-U", "sigcat", *arguments)


def programs() -> Path | None:
    """The folder of the programs of the server; None if they are not installed."""
    found = shutil.which("postgres")
    folders = [
        *sorted(Path("/usr/lib/postgresql").glob("*/bin"), reverse=True),
        *([Path(found).parent] if found else []),
    ]
    return next((folder for folder in folders if (folder / "initdb").exists()), None)


@contextmanager
def running(folder: Path) -> Iterator[Server]:
    """A server that runs in the block."""
    server = Server(folder, Path(tempfile.mkdtemp(prefix="sigcat-server-")))
    try:
        server.start()
        yield server
    finally:
        server.stop()
        shutil.rmtree(server.data.parent, ignore_errors=True)
