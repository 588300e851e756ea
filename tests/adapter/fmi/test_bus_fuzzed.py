"""Random and damaged operations are handed to an FMU with a bus, with sanitizers of the compiler: it answers, and never crashes."""

import json
import re
import subprocess

import pytest

from sigcat.cli import main
from tests.adapter.fmi.bus.made import DBC, HERE, TREE
from tests.adapter.fmi.fmus import SANITIZED
from tests.needs import IS_SLOW_RUN, c_compiler

pytest.importorskip("cantools", reason="cantools: pip install 'sigcat[can]'")
ROUNDS = 100_000 if IS_SLOW_RUN else 5_000


@pytest.fixture(scope="module")
def fuzzed(tmp_path_factory):
    """A program with an FMU in it, the token of the FMU, and the value reference of its first clock."""
    folder = tmp_path_factory.mktemp("fuzz")
    (folder / "deployment.yaml").write_text(f"fmi: {{bus: {{name: Powertrain, dbc: ['{DBC}']}}}}\n")
    options = ["-s", str(TREE), "--deployment", str(folder / "deployment.yaml"), "-o", str(folder / "fmi.json")]
    assert main(["integrate", "fmi", str(HERE / "function.yaml"), *options]) == 0
    assert main(["generate", "fmi", str(folder / "fmi.json"), "-o", str(folder)]) == 0
    (fmu,) = json.loads((folder / "fmi.json").read_text())["FmuList"]
    sources = folder / fmu["Name"] / "sources"
    files = [*sorted(sources.glob("*.c")), HERE / "mirror.c", HERE / "fuzz.c"]
    command = ["gcc", *SANITIZED, f"-I{sources}", f"-I{HERE}", *map(str, files), "-lm", "-o", str(folder / "fuzz")]
    subprocess.run(command, check=True)
    return folder / "fuzz", fmu["InstantiationToken"], str(len(fmu["VariableList"]))


@pytest.mark.parametrize("seed", range(1, 4))
@c_compiler
def test_damaged_operations_never_crash(fuzzed, seed):
    program, token, first = fuzzed
    done = subprocess.run([program, token, str(seed), str(ROUNDS), first], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr[-3000:]
    found = re.fullmatch(r"(\d+) format errors, (\d+) frames\n", done.stdout)
    assert found, done.stdout
    assert min(map(int, found.groups())) > ROUNDS
