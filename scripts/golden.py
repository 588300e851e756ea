"""Write the expected outputs of the examples anew: what `examples/*/build` makes today."""

import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).parents[1]


def build(example: Path, folder: Path) -> None:
    """Run the example's build with this checkout's sigcat."""
    environment = {**os.environ, "SIGCAT": f"{sys.executable} -m sigcat.cli", "PYTHONPATH": str(ROOT / "app")}
    subprocess.run([str(example / "build"), str(folder)], check=True, env=environment)


def main() -> int:
    """Every example that has a build."""
    for script in sorted(ROOT.glob("examples/*/build")):
        expected = script.parent / "expected"
        with tempfile.TemporaryDirectory() as folder:
            build(script.parent, Path(folder))  # what was expected stays, where the build fails
            shutil.rmtree(expected, ignore_errors=True)
            shutil.copytree(folder, expected)
        print(f"{expected.relative_to(ROOT)}: {sum(path.is_file() for path in expected.rglob('*'))} files")
    return 0


if __name__ == "__main__":
    sys.exit(main())
