"""The C sources of the examples, compiled with a program that runs them: the inputs of a step over a pipe in, its outputs out.

Values are doubles, in the order of the fields of a named tuple here and of a struct in `programs/`.
"""

import subprocess
import tempfile
from array import array
from collections.abc import Iterable, Sequence
from functools import cache
from pathlib import Path
from typing import Self

from tests.needs import C_COMPILERS

EXAMPLES = Path(__file__).parents[2] / "examples"
PROGRAMS = Path(__file__).parent / "programs"
SOURCES = {
    "core_acc": "CoreAcc.c",
    "eco_control_mpc": "EcoControlMpc.c",
    "wheel_speed_calculation": "WheelSpeedCalculation.c",
}
OUTPUTS = {"core_acc": 3, "eco_control_mpc": 3, "wheel_speed_calculation": 7}
"""Number of values that the program of a function writes for each step."""
C99 = ("-std=c99", "-x", "c")
CPP17 = ("-std=c++17", "-x", "c++")
WARNINGS = ("-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-pedantic", "-Werror")
BITS = ("-ffp-contract=off",)
_FOLDER = tempfile.TemporaryDirectory(prefix="sigcat-examples-")


def source(function: str) -> Path:
    return EXAMPLES / function / SOURCES[function]


@cache
def program(function: str, options: Sequence[str] = ("-O2", *C99), compiler: Sequence[str] = ()) -> Path:
    """The program of a function; whatever the compiler says is an error."""
    file = Path(_FOLDER.name) / f"{function}{abs(hash((options, compiler)))}"
    command = [
        *(compiler or C_COMPILERS[0]),
        *WARNINGS,
        *BITS,
        *options,
        f"-I{source(function).parent}",
        "-o",
        str(file),
    ]
    done = subprocess.run(
        [*command, str(source(function)), str(PROGRAMS / f"{function}.c"), "-x", "none", "-lm"],
        check=False,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    return file


@cache
def object_file(function: str) -> Path:
    """Return the program that the source of a function is compiled to."""
    file = Path(_FOLDER.name) / f"{function}.o"
    subprocess.run([*C_COMPILERS[0], *BITS, *C99, "-c", source(function), "-o", file], check=True)
    return file


def answer(path: Path, steps: Iterable[Sequence[float]]) -> bytes:
    """Return the answers of a program to the inputs of some steps: the bytes of its outputs."""
    data = b"".join(array("d", step).tobytes() for step in steps)
    done = subprocess.run([path], input=data, capture_output=True, check=False, timeout=120)
    assert (done.returncode, done.stderr.decode()) == (0, "")
    return done.stdout


class Running:
    """A program that runs, one step after the other."""

    def __init__(self, function: str) -> None:
        self._size = 8 * OUTPUTS[function]
        self._process = subprocess.Popen([program(function)], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.initial = self._read()
        """Outputs after the initialization."""

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._process.communicate()
        assert self._process.returncode == 0

    def step(self, inputs: Sequence[float]) -> Sequence[float]:
        """The outputs of a step."""
        assert self._process.stdin
        self._process.stdin.write(array("d", inputs).tobytes())
        self._process.stdin.flush()
        return self._read()

    def end(self) -> Sequence[float]:
        """The outputs after termination."""
        outputs = array("d")
        outputs.frombytes(self._process.communicate()[0])
        return outputs

    def _read(self) -> Sequence[float]:
        assert self._process.stdout
        outputs = array("d")
        outputs.frombytes(self._process.stdout.read(self._size))
        return outputs
