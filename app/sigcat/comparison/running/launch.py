"""A separate program: `launch.py SPEC.json`. Runs processes and a player beside them, and ends when the player does.

It is the first process of a separate network, if there is one: messages of the processes stay on the loopback
interface. When a process dies, everything ends. When the launcher ends, for whatever reason, all of them end.
A line that the player writes to standard output may be a request: `kill NAME`, which is answered with a line. Every other one is a
word of a function that runs in it, and stands with those that it writes to standard error.
"""

import ctypes
import fcntl
import json
import os
import signal
import socket
import struct
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from threading import Thread
from typing import Any

PATIENCE = 10.0
"""Seconds in which processes have to end on request."""
_SET_FLAGS, _UP = 0x8914, 0x1
_DEATH_SIGNAL = 1


def main(arguments: Sequence[str]) -> int:
    """Exit status 0, and what became of the processes in the file that the specification names."""
    spec = json.loads(Path(arguments[0]).read_text("utf-8"))
    die_with_parent()
    for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP):
        signal.signal(number, _stop)
    _loopback_up()
    launch = Launch(Path(spec["told"]))
    try:
        launch.run(spec["processes"], spec["player"])
    finally:
        launch.kill_all()
    Path(spec["outcome"]).write_text(json.dumps(launch.outcome), "utf-8")
    return 0


def die_with_parent() -> None:
    """Linux kills this process when the one that started it ends; elsewhere the launcher's own end has to do."""
    try:
        ctypes.CDLL(None).prctl(_DEATH_SIGNAL, signal.SIGKILL)
    except (AttributeError, OSError):
        return


def _stop(number: int, _: object) -> None:
    raise SystemExit(128 + number)


def _loopback_up() -> None:
    """In a separate network it is down at first; where that is not allowed, it is up already."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        try:
            fcntl.ioctl(any_socket, _SET_FLAGS, struct.pack("16sH14x", b"lo", _UP))
        except PermissionError:
            return


class Launch:
    """Processes that run, by name, and what became of those that ended."""

    def __init__(self, told: Path) -> None:
        self.told = told
        self.running: dict[int, str] = {}
        self.held: list[subprocess.Popen[str]] = []
        """Processes held so that Python does not wait for them by itself."""
        self.meant: set[str] = set()
        """Processes whose end is intended."""
        self.ended: dict[str, dict[str, float]] = {}
        self.first_dead = ""
        self.when = "before the drive did"
        self.began = time.monotonic()
        self.ends = self.began

    @property
    def outcome(self) -> Mapping[str, Any]:
        """Result for the caller."""
        return {"ended": self.ended, "dead": self.first_dead, "when": self.when, "seconds": self.ends - self.began}

    def run(self, processes: Sequence[Mapping[str, Any]], player: Mapping[str, Any]) -> None:
        """Until the player has ended, or a process died before it."""
        for each in processes:
            self._start(each)
        started = self._start(player, is_player=True)
        listener = Thread(target=self._listen, args=(started, player["name"]), daemon=True)
        listener.start()
        while player["name"] not in self.ended and not self.first_dead:
            self._wait(player["name"])
        self.ends = time.monotonic()
        listener.join(PATIENCE if player["name"] in self.ended else 0)  # its last words
        self._end()

    def _start(self, each: Mapping[str, Any], *, is_player: bool = False) -> "subprocess.Popen[str]":
        name = each["name"]
        pipe = subprocess.PIPE if is_player else None
        words = self._words(name)
        words.unlink(missing_ok=True)
        with words.open("ab") as told:
            process = subprocess.Popen(  # noqa: S603 - no shell
                each["command"], env=each["environment"], stdin=pipe or subprocess.DEVNULL, stdout=pipe or told,
                stderr=told, text=True, errors="replace", preexec_fn=die_with_parent,  # noqa: PLW1509 - before any thread
            )  # fmt: skip
        self.held.append(process)
        self.running[process.pid] = name
        return process

    def _words(self, name: str) -> Path:
        return self.told / f"{name}.txt"

    def _listen(self, player: "subprocess.Popen[str]", name: str) -> None:
        assert player.stdout is not None
        assert player.stdin is not None
        with self._words(name).open("a", buffering=1, encoding="utf-8") as told:
            for line in player.stdout:
                what, _, whom = line.strip().partition(" ")
                if what != "kill":
                    told.write(line)
                    continue
                self._kill(whom)
                player.stdin.write("done\n")
                player.stdin.flush()

    def _kill(self, name: str) -> None:
        self.meant.add(name)
        for pid, each in list(self.running.items()):
            if each == name:
                os.kill(pid, signal.SIGKILL)
        until = time.monotonic() + PATIENCE
        while name in self.running.values() and time.monotonic() < until:
            time.sleep(0.001)

    def _wait(self, player: str) -> None:
        """One process ends."""
        pid, status, usage = os.wait3(0)
        name = self.running.pop(pid)
        code = os.waitstatus_to_exitcode(status)
        self.ended[name] = {
            "status": code, "cpu": usage.ru_utime + usage.ru_stime, "rss": usage.ru_maxrss * 1024,
        }  # fmt: skip
        is_expected = name in self.meant or (name == player and code == 0)
        self.first_dead = self.first_dead or ("" if is_expected else name)

    def _end(self) -> None:
        """End those that still run, and kill them if they do not end."""
        told = list(self.running.values())
        self.meant.update(told)
        for pid in list(self.running):
            os.kill(pid, signal.SIGTERM)
        signal.signal(signal.SIGALRM, lambda *_: self.kill_all())
        signal.alarm(int(PATIENCE))
        while self.running:
            self._wait("")
        signal.alarm(0)
        # Killed by the alarm: Fast DDS 2.14 may wait for itself for ever while a participant is taken apart.
        good = (0, -signal.SIGTERM, -signal.SIGKILL)
        failed = [name for name in told if self.ended[name]["status"] not in good]
        if failed and not self.first_dead:
            self.first_dead, self.when = failed[0], "when it was asked to end"

    def kill_all(self) -> None:
        """End all processes."""
        for pid in list(self.running):
            os.kill(pid, signal.SIGKILL)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
