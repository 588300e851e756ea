"""What `examples/*/build` makes is what stands in `expected`, file by file; `make golden` writes it anew."""

import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]

EXAMPLES = sorted(path.parent for path in ROOT.glob("examples/*/build"))


def contents(folder):
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.name)
def test_an_example_is_built_as_expected(example, tmp_path):
    environment = {**os.environ, "SIGCAT": f"{sys.executable} -m sigcat.cli", "PYTHONPATH": str(ROOT / "app")}
    subprocess.run([example / "build", tmp_path], check=True, env=environment)
    made, expected = contents(tmp_path), contents(example / "expected")
    assert list(made) == list(expected)
    for name, data in made.items():
        assert data == expected[name], f"{name} differs: if that is meant, run `make golden`."
