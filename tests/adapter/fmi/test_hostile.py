"""The functions of an FMU are called at random, with sanitizers of the compiler: nothing crashes, and what is wrong is refused."""

import json
import re
import subprocess
from pathlib import Path

import pytest

from sigcat.cli import main
from tests.adapter.fmi.fmus import SANITIZED
from tests.needs import IS_SLOW_RUN, c_compiler

HERE = Path(__file__).parent
CALLS = 1_000_000 if IS_SLOW_RUN else 100_000


@pytest.fixture(scope="module", params=["steps", "clocks", "fmi2"])
def fuzzed(request, tmp_path_factory):
    """A program with an FMU in it, the token of the FMU, and how it is used."""
    folder = tmp_path_factory.mktemp("fuzz")
    settings = {"steps": "{}", "clocks": "{interface: scheduledExecution}", "fmi2": "{version: '2.0'}"}[request.param]
    (folder / "deployment.yaml").write_text(f"name: Fuzzed\nfmi: {settings}\n")
    options = ["--deployment", str(folder / "deployment.yaml"), "-o", str(folder / "fmi.json")]
    assert main(["integrate", "fmi", str(HERE / "averaging/function.yaml"), *options]) == 0
    assert main(["generate", "fmi", str(folder / "fmi.json"), "-o", str(folder)]) == 0
    (fmu,) = json.loads((folder / "fmi.json").read_text())["FmuList"]
    sources = folder / fmu["Name"] / "sources"
    files = [
        *sorted(sources.glob("*.c")),
        HERE / "averaging/averaging.c",
        HERE / ("fuzz2.c" if request.param == "fmi2" else "fuzz.c"),
    ]
    command = [
        "gcc",
        *SANITIZED,
        f"-I{sources}",
        f"-I{HERE / 'averaging'}",
        f"-I{HERE}",
        *map(str, files),
        "-o",
        str(folder / "fuzz"),
    ]
    subprocess.run(command, check=True)
    return folder / "fuzz", fmu["InstantiationToken"], request.param


@pytest.mark.parametrize("seed", range(1, 4))
@c_compiler
def test_random_calls_never_crash(fuzzed, seed):
    program, token, usage = fuzzed
    done = subprocess.run([program, token, str(seed), str(CALLS), usage], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-3000:]
    found = re.fullmatch(r"(\d+) ok, (\d+) refused, (\d+) steps\n", done.stdout)
    assert found, done.stdout
    ok, refused, steps = map(int, found.groups())
    assert min(ok, refused) > CALLS / 20
    assert steps > CALLS / 1000
