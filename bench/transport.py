"""An event between two processes over the bench runtime, beside two programs with a plain UDP socket that send as many bytes."""

import os
import sys
from collections.abc import Sequence
from pathlib import Path
from shutil import which
from statistics import median

from bench.measuring import ROOT, command, interleaved
from bench.rows import Bench, Missing, Row
from sigcat.comparison.running.processes import own_network

EVENTS = 3000
"""At 1 kHz."""
_EXAMPLES = ROOT / "examples"
PROGRAMS = Path(__file__).with_name("programs")
_CODE = {"CORE_ACC_CODE": _EXAMPLES / "core_acc", "ECO_CONTROL_MPC_CODE": _EXAMPLES / "eco_control_mpc"}


def event(bench: Bench) -> Row:
    """Vehicle.Speed from Send, by the receive handler, to GetOutput of CoreAcc."""
    network = needed_network()
    programs = _build(bench.folder)
    adapter: list[float] = []

    def over_someip() -> float:
        sent, read, done = _times(network, programs, "event", ("read", "done"))
        adapter.append(_p50(read, done))
        return _p50(sent, done)

    def over_udp() -> float:
        sent, received = _times(network, programs, "datagram", ("received",))
        return _p50(sent, received)

    figure, reference = interleaved([over_someip, over_udp], bench.runs)
    work = "an event at 1 kHz from `Send` to `GetOutput` of CoreAcc, p50"
    measured = f"{_micro(figure)}; {_micro(median(adapter))} of it `SetInput` and `GetOutput`"
    by_hand = f"as many bytes from `sendto` to `recv`: {_micro(reference)}"
    return Row(work, measured, by_hand, f"{figure / reference:.2f} ×", "at most 3 ×", figure <= 3 * reference)


ROWS = {"event": event}


def needed_network() -> Sequence[str]:
    """Commands that give the programs a separate network, if they can be built."""
    if not which("cmake") or not (os.environ.get("CXX") or which("c++")):
        raise Missing("CMake and a C++ compiler: install cmake and g++")
    network = own_network() if which("ip") else None
    if network is None:
        raise Missing("a separate network: Linux with unshare and ip")
    return network


def _build(folder: Path) -> Path:
    """The folder of the programs, built with the CMake files that are shipped."""
    integration = _EXAMPLES / "ecocontrol/expected/autosar-adaptive.json"
    generate = ("generate", "autosar-adaptive", str(integration), "--bench", "-o", str(folder / "set"))
    command(sys.executable, "-m", "sigcat.cli", *generate)()
    build = folder / "build"
    settings = {"SET": folder / "set", **_CODE, "CMAKE_BUILD_TYPE": "Release", "CMAKE_UNITY_BUILD": "ON"}
    command(
        "cmake", "-S", str(PROGRAMS), "-B", str(build), *(f"-D{name}={value}" for name, value in settings.items())
    )()
    command("cmake", "--build", str(build), "-j", str(os.cpu_count() or 1))()
    return build


def _times(network: Sequence[str], programs: Path, name: str, received: Sequence[str]) -> list[list[int]]:
    """When each was sent, and each time of its receiver, in ns."""
    files = ("sent", *received)
    # The receiver tells the sender by the pipe when to begin, and by its end when to end. Each has a separate core, as
    # on a bus: else the system chooses, and two programs that share one take a tenth of the time, by chance.
    pair = f"{_on(0)}./{name}_receiver {EVENTS} {' '.join(received)} | {_on(-1)}./{name}_sender {EVENTS} sent"
    command(*network, "sh", "-c", f'cd "$0" && ip link set lo up && {pair}', str(programs))()
    times = [[int(line) for line in (programs / file).read_text().split()] for file in files]
    if any(len(each) != EVENTS for each in times):
        raise RuntimeError(
            f"not all that {name}_sender sent was received: {dict(zip(files, map(len, times), strict=True))}"
        )
    return times


def _on(core: int) -> str:
    """Words before a command that keep it on one of the existing cores."""
    return f"taskset -c {sorted(os.sched_getaffinity(0))[core]} " if which("taskset") else ""


def _p50(begins: list[int], ends: list[int]) -> float:
    """The median of the seconds from each begin to its end."""
    return median(end - begin for begin, end in zip(begins, ends, strict=True)) / 1e9


def _micro(seconds: float) -> str:
    return f"{seconds * 1e6:.1f} µs"
