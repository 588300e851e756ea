"""EcoControl as three processes over SOME/IP: `make run-autosar`, or `python -m scripts.run_autosar [SECONDS]`.

Generates the applications, builds them with the bench runtime, plays the recorded drive to them step by step, and holds
what they send against `sigcat simulate`.
"""

import os
import sys
from collections.abc import Mapping
from pathlib import Path

from scripts import recordings
from scripts.recordings import EXAMPLES, WHOLE_DRIVE, Sent, bits, recorded
from sigcat.comparison.running.processes import Process, launched, own_network
from sigcat.players import cmake
from sigcat.players.commands import write

HERE = Path(__file__).parents[1]
INTEGRATION = EXAMPLES / "ecocontrol/expected/autosar-adaptive.json"
CODE = {"CORE_ACC_CODE": EXAMPLES / "core_acc", "ECO_CONTROL_MPC_CODE": EXAMPLES / "eco_control_mpc"}
EXECUTABLES = ("CoreAccExecutable", "EcoControlMpcExecutable")


def main() -> int:
    """Exit status 0 if everything that was sent is what the simulation sends."""
    seconds = int(sys.argv[1]) if len(sys.argv) > 1 else WHOLE_DRIVE
    folder = HERE / "build/autosar"
    generate_into(folder)
    build(folder)
    sent = run(folder, seconds)
    expected = simulated(folder, seconds)
    wrong = differences(sent, expected)
    print(f"{seconds} s, {sum(map(len, sent.values()))} values over SOME/IP")
    print("\n".join(wrong) or "bit for bit what `sigcat simulate` sends")
    return 1 if wrong else 0


def generate_into(folder: Path, integration: Path = INTEGRATION) -> None:
    """Write the applications with the bench."""
    from sigcat.adapter.autosar_adaptive.application.adaptive_application import generate
    from sigcat.limits import DEFAULT_LIMITS

    write(generate(integration.read_bytes(), str(integration), DEFAULT_LIMITS, None, bench=True), folder)


def build(folder: Path, flags: str = "", *options: str, code: Mapping[str, Path] = CODE) -> None:
    """Compile with CMake, few large translation units instead of many small ones."""
    quick = {"CMAKE_UNITY_BUILD": "ON", "CMAKE_UNITY_BUILD_BATCH_SIZE": 100, "CMAKE_CXX_FLAGS": flags}
    cmake.build(folder, folder / "build", {**code, **quick}, *options)


def run(folder: Path, seconds: int) -> Sent:
    """Return the values that the processes send while the drive is played to them."""
    recording, programs = folder / "recorded.csv", folder / "build"
    environment = {**os.environ, "BENCH_PLAYER": "40000"}
    processes = [Process(name, (str(programs / name / name),), environment) for name in EXECUTABLES]
    trace = recordings.normalized(folder / "normalized.tsv")
    command = (str(programs / "player/player"), str(trace), str(recording), str(seconds))
    outcome = launched(processes, Process("player", command, environment), folder / "run", own_network() or ())
    if outcome.last_words:
        raise RuntimeError(outcome.last_words)
    return recorded(recording)


def simulated(folder: Path, seconds: int) -> Sent:
    """Return the values that `sigcat simulate` sends, without safety reactions: no service has them."""
    sent = recordings.simulated(folder / "simulated.csv", seconds)
    return {name: values for name, values in sent.items() if not name.endswith("_SftyCondSts")}


def differences(sent: Sent, expected: Sent) -> list[str]:
    """List values that differ from the expected ones.

    A field has a value from the beginning, so that its first value, and the first verdict of an error that depends on one,
    may come earlier than in the simulation. So only the values of fields after their first value are compared.
    """
    found = []
    for name in sorted({*sent, *expected}):
        both = [_counted(name, each.get(name, [])) for each in (sent, expected)]
        if both[0] != both[1]:
            first = next((pair for pair in zip(*both, strict=False) if pair[0] != pair[1]), "one is longer")
            found.append(f"{name}: {len(both[0])} values, not {len(both[1])}; {first}")
    return found


def _counted(name: str, sent: list[tuple[int, str]]) -> list[tuple[int, object]]:
    if name.startswith("Vehicle."):
        return [(time, bits(value)) for time, value in sent]
    changes = [each for at, each in enumerate(sent) if at == 0 or each[1] != sent[at - 1][1]]
    return list(changes[1:]) if changes and changes[0][1] in ("PASSED", "OFF") else list(changes)


if __name__ == "__main__":
    sys.exit(main())
