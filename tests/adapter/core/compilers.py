"""Checks of generated C in addition to its tests: sanitizers, and compilers of other vendors, by machine."""

import subprocess
import tempfile
from collections.abc import Sequence
from functools import cache
from pathlib import Path

from sigcat.adapter.toolchain import Toolchain, packaged, toolchain

SANITIZERS = ("-fsanitize=address,undefined", "-fno-sanitize-recover=all")
STRICT = ("-Werror", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-pedantic")


@cache
def sanitizers() -> bool:
    """Whether the compiler has them."""
    return not toolchain().is_zig and _compiles("int main(void) { return 0; }", SANITIZERS)


@cache
def has_fused_products() -> bool:
    """Whether this machine has an instruction that multiplies and adds with one rounding."""
    source = """
    int main(void)
    {
        volatile double a = 123.45, b = 100.0, c = -12345.0;
        return (a * b + c) == 0.0;
    }
    """
    return _compiles(source, ("-O2", "-march=native", "-ffp-contract=fast"), runs=True)


def _compiles(source: str, flags: Sequence[str], *, runs: bool = False) -> bool:
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "a.c").write_text(source)
        command = [*toolchain().c, *flags, "a.c", "-o", "a"]
        done = subprocess.run(command, cwd=folder, capture_output=True, check=False)
        if done.returncode != 0:
            return False
        return not runs or subprocess.run([Path(folder) / "a"], check=False).returncode == 0


def compilers() -> dict[str, Toolchain]:
    """The system's compiler, and the one of PyPI beside it."""
    found = {"system": toolchain()}
    other = packaged()
    return found if other is None or toolchain().is_zig else {**found, "ziglang": other}
