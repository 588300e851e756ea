"""A process that forks: a child starts at once, with all that was imported and kept before, and can be ended by force.

A process with threads, such as a service, must not be forked, and a fresh one takes a second to import what it needs. A
zygote has imported it, has one thread and waits. What its children do not change they share with it in memory. It ends
when no process is left that could ask it for children. POSIX only.
"""

import gc
import importlib
import os
import signal
import socket
import struct
import subprocess
import sys
from collections.abc import Iterator, Mapping
from contextlib import suppress
from types import MappingProxyType
from typing import NamedTuple, Protocol, cast

IS_POSSIBLE = hasattr(os, "fork")
"""Whether this system has zygotes."""
LENGTH = struct.Struct("!Q")
"""Length before each message."""
_NICE = 5
"""The process that asks for work by a child runs before it."""
_REQUEST = struct.Struct("!?31s")


class Child(Protocol):
    """The module of a zygote."""

    def keep(self, data: bytes) -> None:
        """Process a message to the zygote: all later children have its values."""

    def prepare(self, kind: str) -> None:
        """Get ready for a child of this kind, in the zygote."""

    def serve(self, connection: socket.socket) -> None:
        """Run a child until the service closes the connection."""


class Zygote:
    """The process, as it is seen from where it was started. `module` names a `Child`."""

    def __init__(self, module: str, variables: Mapping[str, str] = MappingProxyType({})) -> None:
        self._control, theirs = socket.socketpair()
        with theirs:
            self._process = subprocess.Popen(  # noqa: S603 - our own module
                [sys.executable, "-P", "-X", "utf8", "-m", "sigcat.zygote", str(theirs.fileno()), module],
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                env={**os.environ, **variables, "PYTHONPATH": os.pathsep.join(sys.path)},
                pass_fds=(theirs.fileno(),),
                start_new_session=True,  # who interrupts this process with Ctrl+C lets it finish what is under way
            )

    @property
    def has_ended(self) -> bool:
        """Whether it has ended, also while a thread waits for that: then `Popen.poll` does not see it."""
        if self._process.poll() is not None or not hasattr(os, "waitid"):
            return self._process.returncode is not None
        try:
            return os.waitid(os.P_PID, self._process.pid, os.WEXITED | os.WNOHANG | os.WNOWAIT) is not None
        except ChildProcessError:
            return True  # the thread has its status already

    @property
    def is_closed(self) -> bool:
        """Whether this process lets it end."""
        return self._control.fileno() < 0

    def wait(self) -> int:
        """The exit status, once it has ended; below 0 the signal that killed it."""
        return self._process.wait()

    def child(self, kind: str = "") -> socket.socket:
        """A connection to a new child, which ends when it is closed. Raises OSError if the zygote has ended."""
        return self._asked(kind, is_told=False)

    def tell(self, data: bytes) -> None:
        """Let the zygote keep something; waits until it reads. Raises OSError if it has ended."""
        with self._asked("", is_told=True) as connection:
            write_message(connection, data)

    def close(self) -> None:
        """Let it end, and its children as soon as their connections are closed."""
        self._control.close()
        self._process.wait()

    def _asked(self, kind: str, *, is_told: bool) -> socket.socket:
        ours, theirs = socket.socketpair()
        with theirs:
            socket.send_fds(self._control, [_REQUEST.pack(is_told, kind.encode())], [theirs.fileno()])
        return ours


# -- in the process -----------------------------------------------------------------------------------------------


class _Request(NamedTuple):
    is_told: bool
    kind: str
    connection: socket.socket


def main(descriptor: int, module: str) -> None:
    """Fork as often as it is asked for. The module is imported with the first request."""
    for ignored in (signal.SIGHUP, signal.SIGINT, signal.SIGTERM):  # a service finishes its work first
        signal.signal(ignored, signal.SIG_IGN)
    children: set[int] = set()
    signal.signal(signal.SIGCHLD, lambda _signal, _frame: _take_leave(children))
    gc.disable()  # what is imported and kept stays
    with socket.socket(fileno=descriptor) as control:
        for request in _requests(control):
            child = cast(Child, importlib.import_module(module))
            with request.connection:
                if request.is_told:
                    data = read_message(request.connection)
                    if data is not None:  # else whoever started this process ended while it sent
                        child.keep(data)
                    continue
                child.prepare(request.kind)
                gc.freeze()
                process = os.fork()
                if process == 0:
                    signal.signal(signal.SIGCHLD, signal.SIG_DFL)  # what it starts is its own
                    control.close()
                    _live(child, request.connection)
                children.add(process)


def _requests(control: socket.socket) -> Iterator[_Request]:
    while True:
        data, descriptors, _, _ = socket.recv_fds(control, _REQUEST.size, 1)
        if not descriptors:
            return
        is_told, kind = _REQUEST.unpack(data)
        yield _Request(is_told, kind.rstrip(b"\0").decode(), socket.socket(fileno=descriptors[0]))


def _take_leave(children: set[int]) -> None:
    """Reap children as soon as one ends: until then the system keeps an entry for each."""
    for process in tuple(children):
        with suppress(ChildProcessError):
            if os.waitpid(process, os.WNOHANG) == (0, 0):
                continue
        children.discard(process)


def _live(child: Child, connection: socket.socket) -> None:
    """The whole life of a child: it never comes back into the loop of the zygote."""
    status = 1
    try:
        gc.enable()
        os.nice(_NICE)
        child.serve(connection)
        status = 0
    except ConnectionError:
        status = 0  # no process waits for it any more
    except BaseException:  # noqa: BLE001 - told like any other that ends a process
        sys.excepthook(*sys.exc_info())
    finally:
        os._exit(status)


def read_message(connection: socket.socket) -> bytes | None:
    """The next message; None if the other side closed the connection."""
    head = _exactly(LENGTH.size, connection)
    return None if head is None else _exactly(LENGTH.unpack(head)[0], connection)


def write_message(connection: socket.socket, data: bytes) -> None:
    """Send a message."""
    connection.sendall(LENGTH.pack(len(data)) + data)


def _exactly(size: int, connection: socket.socket) -> bytes | None:
    data = b""
    while len(data) < size:  # a signal, such as that of a child that ends, leaves the rest to the next call
        part = connection.recv(size - len(data), socket.MSG_WAITALL)
        if not part:
            return None
        data = data + part if data else part
    return data


if __name__ == "__main__":
    main(int(sys.argv[1]), sys.argv[2])
