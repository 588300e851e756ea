"""Processes of a platform, started, watched and ended: by the launcher, which is a separate process."""

import json
import signal
import subprocess
import sys
import time
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat.comparison.recording import ProcessLoad
from sigcat.players.commands import GROUPS

_LAUNCHER = Path(__file__).with_name("launch.py")
_TOLD = "launcher.txt"
_LAST_LINES = 8
_LOOK = 0.5
"""Seconds after which one looks whether something was recorded."""


class Process(NamedTuple):
    """A process to start, and the files that count as its program."""

    name: str
    command: tuple[str, ...]
    environment: Mapping[str, str]
    program: tuple[Path, ...] = ()
    """Its executable, with what was built for it."""


class Outcome(NamedTuple):
    """Result of running processes."""

    loads: tuple[ProcessLoad, ...]
    last_words: str
    """Last lines of the first one that died; empty if none did."""
    seconds: float
    """Until the player had ended."""


def launched(
    processes: Sequence[Process],
    player: Process,
    folder: Path,
    network: Sequence[str] = (),
    patience: float | None = None,
) -> Outcome:
    """Run processes until the player has ended, or one has died. All of them have ended afterwards, however this ends.

    With a patience, they are ended when nothing was recorded in the folder for so many seconds.
    """
    folder.mkdir(parents=True, exist_ok=True)
    spec, outcome = folder / "launch.json", folder / "outcome.json"
    outcome.unlink(missing_ok=True)
    spec.write_text(
        json.dumps(
            {
                "processes": [_described(each) for each in processes],
                "player": _described(player),
                "told": str(folder),
                "outcome": str(outcome),
            }
        ),
        "utf-8",
    )
    status = _run_to_end([*network, sys.executable, str(_LAUNCHER), str(spec)], folder, patience)
    if status is None:
        words = last_lines(folder / f"{player.name}.txt")
        return Outcome((), f"{player.name} hangs: nothing was recorded for {patience:g} s. {words}".strip(), 0.0)
    if not outcome.exists():
        words = last_lines(folder / _TOLD)
        return Outcome((), f"The launcher ended with status {status}. {words}".strip(), 0.0)
    return _outcome(json.loads(outcome.read_text("utf-8")), (*processes, player), folder)


def _described(process: Process) -> Mapping[str, object]:
    return {"name": process.name, "command": process.command, "environment": process.environment}


def _run_to_end(command: Sequence[str], folder: Path, patience: float | None) -> int | None:
    """The status of a command, which leads its own group that is ended with it; None: nothing was recorded for too long."""
    with (
        (folder / _TOLD).open("wb") as output,
        GROUPS.started(command, stdin=subprocess.DEVNULL, stdout=output, stderr=output) as process,
    ):
        recorded, since = -1, time.monotonic()
        while patience is None or time.monotonic() - since < patience:
            try:
                return int(process.wait(None if patience is None else min(patience, _LOOK)))
            except subprocess.TimeoutExpired:
                files = list(folder.rglob("*"))
                if (now := len(files) + _size(files)) != recorded:
                    recorded, since = now, time.monotonic()
        return None


def _outcome(told: Mapping[str, object], processes: Sequence[Process], folder: Path) -> Outcome:
    ended, dead, seconds = told["ended"], told["dead"], told["seconds"]
    assert isinstance(ended, dict)
    loads = tuple(
        ProcessLoad(
            each.name, ended[each.name]["cpu"], ended[each.name]["rss"], _size(each.program), each is processes[-1]
        )
        for each in processes if each.name in ended
    )  # fmt: skip
    words = _died(str(dead), str(told["when"]), ended, folder) if dead else ""
    return Outcome(loads, words, float(str(seconds)))


def _died(name: str, when: str, ended: Mapping[str, Mapping[str, int]], folder: Path) -> str:
    status = ended[name]["status"]
    how = f"status {status}" if status >= 0 else _signal_name(-status)
    words = last_lines(folder / f"{name}.txt")
    return f"{name} ended with {how} {when}{f': {words}' if words else ', without a message'}"


def _signal_name(number: int) -> str:
    try:
        return signal.Signals(number).name
    except ValueError:
        return f"signal {number}"


def last_lines(path: Path) -> str:
    """Return the last lines that a process printed, if any."""
    lines = path.read_text("utf-8", "replace").splitlines() if path.exists() else []
    return "\n".join([line for line in lines if line.strip()][-_LAST_LINES:])


def _size(program: Iterable[Path]) -> int:
    return sum(each.stat().st_size for each in program if each.is_file())


def own_network() -> tuple[str, ...] | None:
    """The command that gives a process a separate network; None where this is not allowed."""
    for command in (("unshare", "-n"), ("unshare", "-Urn")):
        try:
            done = subprocess.run([*command, "true"], check=False, capture_output=True)  # noqa: S603
        except OSError:
            return None
        if done.returncode == 0:
            return command
    return None
