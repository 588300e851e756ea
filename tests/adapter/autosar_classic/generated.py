"""Functions, generated and built for AUTOSAR Classic."""

import csv
import subprocess
import tempfile
from collections import defaultdict
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import NamedTuple

from sigcat.adapter.autosar_classic.classic_software import generate
from sigcat.catalogue.hosting.source import load
from sigcat.catalogue.hosting.sources import shipped_sources
from sigcat.comparison.running.autosar_classic import AUTOSAR_CLASSIC
from sigcat.comparison.running.recorded import write_normalized
from sigcat.comparison.running.runner import Subject
from sigcat.comparison.running.simulation import SIMULATION
from sigcat.function.function_json.resolved_function import ResolvedFunction
from sigcat.integration.reading import read_functions
from sigcat.limits import DEFAULT_LIMITS
from sigcat.names import screaming_snake_case
from sigcat.platforms.deployment_file import DEFAULT_DEPLOYMENT
from sigcat.platforms.integrate import integrate
from sigcat.platforms.table import PLATFORMS
from sigcat.runs.prepare import prepare

ROOT = Path(__file__).parents[3]
EXAMPLES, CASES = ROOT / "examples", ROOT / "tests/runs/cases"
APPLICATIONS = ROOT / "tests/adapter/autosar_adaptive/application"
ECOCONTROL = (EXAMPLES / "core_acc/function.yaml", EXAMPLES / "eco_control_mpc/function.yaml")
DRIVE = EXAMPLES / "ecocontrol/drive.csv"
SECOND = 10**9


@cache
def functions(paths: tuple[Path, ...]) -> tuple[ResolvedFunction, ...]:
    """Functions of files, with the shipped catalogue."""
    found, _ = read_functions([(path.read_bytes(), str(path)) for path in paths], load(shipped_sources()[0]))
    return found


@cache
def document(paths: tuple[Path, ...]) -> bytes:
    """Their Integration JSON."""
    return integrate(PLATFORMS["autosar-classic"], functions(paths), DEFAULT_DEPLOYMENT).document


@cache
def files(paths: tuple[Path, ...]) -> Mapping[str, str]:
    """Everything that is generated, with the test RTE."""
    return files_of(document(paths))


def files_of(changed: bytes) -> Mapping[str, str]:
    """Those of a document that someone has changed."""
    return {file.name: file.data.decode() for file in generate(changed, "classic.json", DEFAULT_LIMITS, bench=True)}


def written(folder: Path, paths: tuple[Path, ...], changed: Mapping[str, str] | None = None) -> Path:
    """The files in a folder, some of them changed."""
    for name, text in {**files(paths), **(changed or {})}.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text)
    return folder


def built(folder: Path, paths: tuple[Path, ...], *flags: str) -> Path:
    """The program of the test RTE."""
    settings = [
        f"-D{screaming_snake_case(each.name)}_CODE={path.parent}"
        for each, path in zip(functions(paths), paths, strict=True)
    ]
    options = [f"-DCMAKE_{language}_FLAGS={' '.join(flags)}" for language in ("C", "CXX")]
    for command in (
        ["cmake", "-S", folder, "-B", folder / "build", *settings, *options],
        ["cmake", "--build", folder / "build"],
    ):
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stdout + done.stderr
    program = folder / "build/test_rte"
    _BUILT_FROM[program] = paths
    return program


_BUILT_FROM: dict[Path, tuple[Path, ...]] = {}
"""Functions of each program."""


class Played(NamedTuple):
    """The values that components sent, and the calls of services."""

    sent: Mapping[str, list[tuple[int, str]]]
    """Times in ns and texts, by name."""
    told: list[tuple[int, str, str, str]]
    """Times, services, what it is about, what was said."""

    def of(self, service: str) -> list[tuple[int, str, str]]:
        return [(time, name, value) for time, one, name, value in self.told if one == service]


def play(program: Path, trace: Path | str, length: int, *options: str) -> Played:
    """Play a trace, or its text. A sanitizer has nothing to say."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        if isinstance(trace, str):
            (folder / "trace.csv").write_text(trace)
            trace = folder / "trace.csv"
        write_normalized(trace, subject(_BUILT_FROM[program]).prepared, folder / "normalized.tsv")
        command = [
            program,
            "lock",
            folder / "normalized.tsv",
            folder / "recorded.csv",
            folder / "services.csv",
            length,
            *options,
        ]
        done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        return Played(_sent(folder / "recorded.csv"), _told(folder / "services.csv"))


def _sent(path: Path) -> Mapping[str, list[tuple[int, str]]]:
    found: defaultdict[str, list[tuple[int, str]]] = defaultdict(list)
    with path.open(newline="") as file:
        for row in csv.DictReader(file):
            found[row["name"]].append((int(row["time"]), row["value"]))
    return found


def _told(path: Path) -> list[tuple[int, str, str, str]]:
    with path.open(newline="") as file:
        return [(int(row["time"]), row["service"], row["name"], row["value"]) for row in csv.DictReader(file)]


def subject(paths: Sequence[Path]) -> Subject:
    """The compared parts."""
    found = functions(tuple(paths))
    return Subject(found, prepare(found), DEFAULT_DEPLOYMENT)


RUNNERS = (SIMULATION, AUTOSAR_CLASSIC)
