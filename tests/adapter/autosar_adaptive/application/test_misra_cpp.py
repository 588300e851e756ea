"""clang-tidy finds nothing in generated C++ but what docs/reference/misra-cpp.md gives reasons for."""

import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from sigcat.data import EXAMPLES
from tests.adapter.autosar_adaptive.application.generated import FULL, PACED, full, paced, write
from tests.needs import slow

PAGE = (EXAMPLES.parent / "docs/reference/misra-cpp.md").read_text()
CLANG_TIDY = shutil.which("clang-tidy", path=str(Path(sys.executable).parent))
OWN = r"/(application|\w+Executable)/"
"""Folders that the page is about."""


def rows(title: str) -> list[list[str]]:
    """Cells of the table below a title."""
    part = PAGE.partition(f"## {title}\n")[2].partition("\n\nWhat clang-tidy")[0].partition("\n## ")[0]
    return [
        re.split(r" *\| *", line.strip("| "))
        for line in part.splitlines()
        if re.match(r"\| [^r-]", line) or "`" in line
    ]


def checks() -> list[str]:
    """Every check of the page."""
    return [name for row in rows("Checks") for name in re.findall(r"`([\w*-]+)`", row[-1])]


def deviations() -> dict[str, str]:
    """Checks that may find something, each with the place that its row names."""
    return {row[0].strip("`"): row[2] for row in rows("Deviations") if row[0].startswith("`")}


def findings(folder: Path, source: str, code: Path) -> list[tuple[str, str, str]]:
    """File, check and line of each finding in generated C++."""
    if CLANG_TIDY is None:
        pytest.skip("clang-tidy: pip install clang-tidy")
    includes = ("-I.", "-Igenerated/include", "-Ibench/include", f"-I{code}")
    command = [
        CLANG_TIDY,
        "--quiet",
        f"--checks=-*,{','.join(checks())}",
        f"--header-filter={OWN}",
        source,
        "--",
        "-std=c++17",
    ]
    done = subprocess.run([*command, *includes], cwd=folder, capture_output=True, text=True, check=False)
    assert "error:" not in done.stdout, done.stdout
    found = re.findall(r"^(\S+?):(\d+):\d+: warning: .* \[([\w.-]+)\S*\]$", done.stdout, re.MULTILINE)
    return [(name, check, line) for name, line, check in found if _is_generated(folder, name)]


def _is_generated(folder: Path, name: str) -> bool:
    path = (folder / name).resolve()
    return (
        path.is_relative_to(folder.resolve()) and re.search(OWN, f"/{path.relative_to(folder.resolve())}") is not None
    )


def undocumented(folder: Path, source: str, code: Path) -> list[tuple[str, str, str]]:
    """Findings that no deviation explains."""
    allowed = deviations()
    return [each for each in findings(folder, source, code) if each[1] not in allowed]


def test_the_page_lists_checks_and_deviations() -> None:
    assert len(checks()) > 25
    assert deviations().keys() <= set(checks())


def test_the_adapter_of_a_function_with_everything_has_documented_deviations_alone(tmp_path: Path) -> None:
    write(full(), tmp_path)
    found = findings(tmp_path, "FullExecutable/full_adapter.cpp", FULL)
    assert [each for each in found if each[1] not in deviations()] == []
    assert {check for _, check, _ in found} == deviations().keys(), "A deviation that is not there is not listed."


def test_threads_and_watches_have_documented_deviations_alone(tmp_path: Path) -> None:
    write(paced(), tmp_path)
    assert undocumented(tmp_path, "application/call_thread.cpp", PACED) == []


@slow
@pytest.mark.parametrize(
    "source",
    ["application/watch.cpp", "application/clock.cpp", "PacedExecutable/main.cpp", "PacedExecutable/paced_adapter.cpp"],
)
def test_the_rest_has_documented_deviations_alone(source: str, tmp_path: Path) -> None:
    write(paced(), tmp_path)
    assert undocumented(tmp_path, source, PACED) == []


def test_a_breach_is_found(tmp_path: Path) -> None:
    write(paced(), tmp_path)
    (tmp_path / "application/breach.cpp").write_text("int Breach(double x) { return (int)x; }\n")
    assert [check for _, check, _ in undocumented(tmp_path, "application/breach.cpp", PACED)] == [
        "modernize-avoid-c-style-cast"
    ]
