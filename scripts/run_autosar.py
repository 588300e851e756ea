"""EcoControl as three processes over SOME/IP: `make run-autosar`, or `python -m scripts.run_autosar [SECONDS]`.

Generates the applications, builds them with the bench runtime, plays the recorded drive to them step by step, and holds
what they send against `sigcat simulate`.
"""

import csv
import json
import os
import struct
import subprocess
import sys
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

HERE = Path(__file__).parents[1]
EXAMPLES = HERE / "examples"
DRIVE = EXAMPLES / "ecocontrol/drive.csv"
INTEGRATION = EXAMPLES / "ecocontrol/expected/autosar-adaptive.json"
CODE = {"CORE_ACC_CODE": EXAMPLES / "core_acc", "ECO_CONTROL_MPC_CODE": EXAMPLES / "eco_control_mpc"}
EXECUTABLES = ("CoreAccExecutable", "EcoControlMpcExecutable")
WHOLE_DRIVE = 600

Sent = Mapping[str, list[tuple[int, str]]]
"""What was sent, by name: times in ns and values."""


def main() -> int:
    """Exit status 0 if everything that was sent is what the simulation sends."""
    seconds = int(sys.argv[1]) if len(sys.argv) > 1 else WHOLE_DRIVE
    folder = HERE / "build/autosar"
    generate_into(folder)
    build(folder)
    recorded = run(folder, seconds)
    expected = simulated(folder, seconds)
    wrong = differences(recorded, expected)
    print(f"{seconds} s, {sum(map(len, recorded.values()))} values over SOME/IP")
    print("\n".join(wrong) or "bit for bit what `sigcat simulate` sends")
    return 1 if wrong else 0


def generate_into(folder: Path, integration: Path = INTEGRATION) -> None:
    """Write the applications with the bench."""
    from sigcat.adapter.autosar_adaptive.application.generate import generate
    from sigcat.limits import DEFAULT_LIMITS

    for file in generate(integration.read_bytes(), str(integration), DEFAULT_LIMITS, None, bench=True):
        path = folder / file.name
        if not path.exists() or path.read_bytes() != file.data:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(file.data)


def build(folder: Path, flags: str = "", *options: str, code: Mapping[str, Path] = CODE) -> None:
    """Compile with CMake, few large translation units instead of many small ones."""
    settings = [f"-D{name}={path}" for name, path in code.items()]
    quick = ["-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=100", f"-DCMAKE_CXX_FLAGS={flags}"]
    _run("cmake", "-S", str(folder), "-B", str(folder / "build"), *settings, *quick, *options)
    _run("cmake", "--build", str(folder / "build"), "-j", str(os.cpu_count() or 1))


def _run(*command: str) -> None:
    done = subprocess.run(command, check=False, capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(f"{' '.join(command)}\n{done.stdout[-3000:]}{done.stderr[-3000:]}")


def has_own_network() -> bool:
    """Whether a process may have a network of its own."""
    return own_network() is not None


def own_network() -> Sequence[str] | None:
    """The command that gives a process a network of its own; None where it may not have one."""
    for command in (("unshare", "-n"), ("unshare", "-Urn")):
        try:
            if subprocess.run([*command, "true"], check=False, capture_output=True).returncode == 0:
                return command
        except OSError:
            return None
    return None


def run(folder: Path, seconds: int) -> Sent:
    """What the processes send while the drive is played to them."""
    recorded = folder / "recorded.csv"
    script = [sys.executable, str(HERE / "scripts/bench_run.py"), str(folder / "build"), *EXECUTABLES]
    _run(*(own_network() or ()), *script, "--", str(DRIVE), str(recorded), str(seconds))
    with recorded.open(newline="", encoding="utf-8") as file:
        return _by_name((int(row["time"]), row["name"], row["value"]) for row in csv.DictReader(file))


def simulated(folder: Path, seconds: int) -> Sent:
    """What `sigcat simulate` sends, without safety reactions: no service has them."""
    out = folder / "simulated.csv"
    functions = [str(EXAMPLES / name / "function.yaml") for name in ("core_acc", "eco_control_mpc")]
    sigcat = [sys.executable, "-m", "sigcat.cli", "simulate", *functions, "--trace", str(DRIVE)]
    _run(*sigcat, "--duration", str(seconds), "-o", str(out))
    return _by_name(_simulated_values(out))


def _simulated_values(path: Path) -> Iterator[tuple[int, str, str]]:
    with path.open(newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            time = round(float(row.pop("time")) * 1e9)
            for name, value in row.items():
                if value and name != "call" and not name.endswith("_SftyCondSts"):
                    yield time, name, value


def _by_name(values: Iterator[tuple[int, str, str]]) -> Sent:
    found: defaultdict[str, list[tuple[int, str]]] = defaultdict(list)
    for time, name, value in values:
        found[name].append((time, value))
    return found


def differences(recorded: Sent, expected: Sent) -> list[str]:
    """What was sent otherwise than expected.

    A field has a value from the beginning, so that its first value, and the first verdict of an error that depends on one,
    may come earlier than in the simulation: of fields, what comes after their first value counts.
    """
    found = []
    for name in sorted({*recorded, *expected}):
        both = [_counted(name, sent.get(name, [])) for sent in (recorded, expected)]
        if both[0] != both[1]:
            first = next((pair for pair in zip(*both, strict=False) if pair[0] != pair[1]), "one is longer")
            found.append(f"{name}: {len(both[0])} values, not {len(both[1])}; {first}")
    return found


def _counted(name: str, sent: list[tuple[int, str]]) -> list[tuple[int, object]]:
    if name.startswith("Vehicle."):
        return [(time, _bits(value)) for time, value in sent]
    changes = [each for at, each in enumerate(sent) if at == 0 or each[1] != sent[at - 1][1]]
    return list(changes[1:]) if changes and changes[0][1] in ("PASSED", "OFF") else list(changes)


def _bits(value: str) -> object:
    """The bits of a float."""
    number = json.loads(value)
    return struct.pack("<f", number) if isinstance(number, float | int) else number


if __name__ == "__main__":
    sys.exit(main())
