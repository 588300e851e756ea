"""The expected outputs of the examples: what `examples/*/build` makes with the sigcat of this checkout."""

import os
import subprocess
import sys
import tempfile
from collections.abc import Mapping
from pathlib import Path

ROOT = Path(__file__).parents[1]


def files() -> Mapping[str, str]:
    """Return the contents of `expected` next to each build."""
    made: dict[str, str] = {}
    for script in sorted(ROOT.glob("examples/*/build")):
        expected = script.parent.relative_to(ROOT) / "expected"
        made |= {f"{expected}/{name}": text for name, text in build(script).items()}
    return made


def build(script: Path) -> Mapping[str, str]:
    """Return the files that one build makes, by their paths in its folder."""
    environment = {**os.environ, "SIGCAT": f"{sys.executable} -m sigcat.cli", "PYTHONPATH": str(ROOT / "app")}
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([str(script), folder], check=False, env=environment, capture_output=True, text=True)
        assert done.returncode == 0, done.stderr
        made = sorted(path for path in Path(folder).rglob("*") if path.is_file())
        return {path.relative_to(folder).as_posix(): path.read_bytes().decode("utf-8") for path in made}
