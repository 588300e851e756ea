"""The stored runs of the examples: the beginning of their drives, as `sigcat simulate` writes it."""

import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from sigcat.cli import main

ROOT = Path(__file__).parents[1]
EXAMPLES = "examples"


class Example(NamedTuple):
    """A run of functions with the drive of a folder."""

    functions: Sequence[str]
    duration: int
    """In seconds: long enough to show something, and short, since it travels in the package."""

    def command(self, folder: str, output: str) -> list[str]:
        """Command that makes the run."""
        declared = [f"{EXAMPLES}/{name}/function.yaml" for name in self.functions]
        trace = ["--trace", f"{EXAMPLES}/{folder}/drive.csv", "--duration", str(self.duration)]
        return ["simulate", *declared, *trace, "-o", output]


RUNS = {
    "ecocontrol": Example(("core_acc", "eco_control_mpc"), 60),
    "wheel_speed_calculation": Example(("wheel_speed_calculation",), 40),
}
"""By the folders of the drives."""


def files() -> Mapping[str, str]:
    """Each run as CSV."""
    return {f"{EXAMPLES}/{folder}/run.csv": run(folder, example) for folder, example in RUNS.items()}


def run(folder: str, example: Example) -> str:
    """Return the output of one run."""
    with tempfile.TemporaryDirectory() as made:
        output = Path(made, "run.csv")
        command = [
            str(ROOT / word) if word.startswith(EXAMPLES) else word for word in example.command(folder, str(output))
        ]
        assert main(command) == 0, command
        return output.read_text(encoding="utf-8")
