"""The cores of the examples compile without a warning, as C99 and as C++17; `make generate` keeps their text."""

import subprocess
from pathlib import Path

import pytest

from sigcat.adapter.toolchain import EXACT, toolchain

ROOT = Path(__file__).parents[3]
CORES = {
    "core_acc": "ecocontrol/expected/core/CoreAcc_adapter.c",
    "eco_control_mpc": "ecocontrol/expected/core/EcoControlMpc_adapter.c",
    "wheel_speed_calculation": "wheel_speed_calculation/expected/core/WheelSpeedCalculation_adapter.c",
}
STRICT = ("-Werror", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-pedantic", *EXACT)


@pytest.mark.parametrize("example", CORES)
@pytest.mark.parametrize("language", ["c99", "c++17"])
def test_no_compiler_warns(example, language, tmp_path):
    compiler = toolchain().c if language == "c99" else toolchain().cpp
    source = ROOT / "examples" / CORES[example]
    kind = "c" if language == "c99" else "c++"
    command = [
        *compiler,
        f"-std={language}",
        *STRICT,
        f"-I{ROOT / 'examples' / example}",
        "-x",
        kind,
        "-c",
        str(source),
    ]
    done = subprocess.run([*command, "-o", str(tmp_path / "core.o")], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
