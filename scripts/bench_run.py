"""Runs the processes of a built application and the player: `bench_run.py BUILD EXECUTABLE... -- TRACE RECORDED SECONDS`.

It is the first process of a network of its own, or of the machine's: what they send stays on the loopback interface.
"""

import fcntl
import os
import signal
import socket
import struct
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

PORT = "40000"
"""At which the player waits for the components."""
_SET_FLAGS = 0x8914
_UP = 0x1


def main(arguments: Sequence[str]) -> int:
    """Exit status 0 if the player and every process have ended well."""
    build, *rest = arguments
    end = rest.index("--")
    _loopback_up()
    environment = {**os.environ, "BENCH_PLAYER": PORT}
    started = [subprocess.Popen([Path(build, name, name)], env=environment) for name in rest[:end]]
    player = subprocess.run([Path(build, "player/player"), *rest[end + 1 :]], env=environment, check=False)
    for each in started:
        each.send_signal(signal.SIGTERM)
    ends = [each.wait(timeout=10) for each in started]
    return 1 if player.returncode or any(ends) else 0


def _loopback_up() -> None:
    """In a network of its own it is down at first; where that is not allowed, it is up already."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        try:
            fcntl.ioctl(any_socket, _SET_FLAGS, struct.pack("16sH14x", b"lo", _UP))
        except PermissionError:
            return


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
