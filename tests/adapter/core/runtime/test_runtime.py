"""Functions in C that all cores share: each rule by a case, each branch reached, and each fault found."""

import contextlib
import json
import re
import shutil
import subprocess
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import NamedTuple

import pytest

from sigcat.adapter.core.generate import RUNTIME_SOURCE, runtime_files
from sigcat.adapter.core.numbers import DOUBLE, FLOAT, NumberType
from sigcat.adapter.toolchain import EXACT, toolchain
from tests.adapter.core.compilers import SANITIZERS, STRICT, sanitizers
from tests.needs import IS_SLOW_RUN

CASES, FLOAT_CASES = (Path(__file__).with_name(name) for name in ("cases.c", "float_cases.h"))
ARITHMETICS = (DOUBLE, FLOAT)
SOURCES = ("sigcat_core.c", "sigcat_core_functions.h")
CHANGES = (
    (r"(?<![<>=!-])>(?![>=])", ">="), (r">=", ">"), (r"(?<![<=])<(?![<=])", "<="), (r"<=", "<"),
    (r"==", "!="), (r"!=", "=="), (r"&&", "||"), (r"\|\|", "&&"), (r" \+ ", " - "), (r" - ", " + "), (r"\+\+", "--"),
    (r"--", "++"), (r"\+=", "-="), (r"\btrue\b", "false"), (r"\bfalse\b", "true"), (r"\b0U;", "1U;"),
)  # fmt: skip
EQUAL = re.compile(
    r"value [<>]= \(Sigcat_Real\)(?:least|most|0|INT64_MAX|UINT64_MAX)|-\(Sigcat_Real\)9223"  # the limit itself
    r"|value > 0\.0F?\) |value < 0\.0F?\) |value > DBL_MAX|value < -DBL_MAX"
    r"|reception->time > entered|return \(a [<>] b\)|\(value [<>] (?:least|most)|\(value < 0\)|t > \*now|#if|-\(double\)FLT_MAX"
    r"|\(more > |\(value < \(Sigcat_Real\)INT64_MAX\)|value == value"
    r"|value >= -FLT_MAX|source >= -FLT_MAX|-LargestSplit|value >= 0\.0F|value < 0\.0F"
)
"""Lines in which a limit and what is beside it give the same number."""


class Mutant(NamedTuple):
    """A change of one place."""

    file: str
    line: int
    text: str
    place: int


def text_of(name: str) -> str:
    (data,) = (file.data for file in runtime_files() if file.name == name)
    return data.decode()


def mutants() -> Iterator[Mutant]:
    for name in SOURCES:
        for number, line in enumerate(text_of(name).partition("template <")[0].split("\n")):
            code = "" if line.startswith((" *", "#")) or EQUAL.search(line) else line.partition("/*")[0]
            for pattern, by in CHANGES:
                for found in re.finditer(pattern, code):
                    yield Mutant(name, number, f"{line[: found.start()]}{by}{line[found.end() :]}", found.start())


@cache
def every_mutant() -> tuple[Mutant, ...]:
    return tuple(dict.fromkeys(mutants()))


def written(folder: Path, arithmetic: NumberType) -> Path:
    for file in runtime_files(arithmetic):
        (folder / file.name).write_bytes(file.data)
    for path in (CASES, FLOAT_CASES):
        shutil.copyfile(path, folder / path.name)
    return folder


def compiled(folder: Path, *flags: str) -> Path:
    command = [*toolchain().c, *flags, *EXACT, RUNTIME_SOURCE, CASES.name, "-o", "cases", "-lm"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return folder / "cases"


def passes(program: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([program], cwd=program.parent, capture_output=True, text=True, check=False, timeout=20)


@pytest.mark.parametrize("arithmetic", ARITHMETICS)
@pytest.mark.parametrize("standard", ["c99", "c11", "c17"])
def test_every_case_holds_without_a_warning(standard, arithmetic, tmp_path):
    promotion = ("-Wdouble-promotion",) if arithmetic == FLOAT else ()
    flags = (f"-std={standard}", *STRICT, *promotion, "-Wno-unused-function")
    done = passes(compiled(written(tmp_path, arithmetic), *flags))
    assert (done.returncode, done.stdout) == (0, "")


@pytest.mark.parametrize("arithmetic", ARITHMETICS)
def test_every_case_holds_under_sanitizers(arithmetic, tmp_path):
    if not sanitizers():
        pytest.skip("sanitizers: a compiler that has them")
    done = passes(compiled(written(tmp_path, arithmetic), "-std=c99", *SANITIZERS))
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@pytest.mark.parametrize("arithmetic", ARITHMETICS)
def test_every_branch_is_taken(arithmetic, tmp_path):
    if shutil.which("gcov") is None or "gcc" not in Path(toolchain().c[0]).name:
        pytest.skip("gcov: install gcc")
    passes(compiled(written(tmp_path, arithmetic), "-std=c99", "-O0", "--coverage"))
    notes = [path.name for path in tmp_path.glob("*sigcat_core.gcda")]
    done = subprocess.run(["gcov", "-b", "-j", "-t", *notes], cwd=tmp_path, capture_output=True, check=True)
    (source,) = (file for file in json.loads(done.stdout)["files"] if file["file"] == RUNTIME_SOURCE)
    missed = [line["line_number"] for line in source["lines"] if line["count"] == 0]
    missed += [line["line_number"] for line in source["lines"] for each in line["branches"] if each["count"] == 0]
    assert missed == []
    assert len(source["lines"]) > 100


def test_there_are_many_faults():
    assert len(every_mutant()) > 100


@pytest.mark.parametrize(
    "mutant",
    every_mutant() if IS_SLOW_RUN else every_mutant()[::9],
    ids=lambda mutant: f"{mutant.file}-{mutant.line + 1}-{mutant.place}-{len(mutant.text)}",
)
def test_a_fault_is_found(mutant, tmp_path):
    rows = text_of(mutant.file).split("\n")
    rows[mutant.line] = mutant.text
    with contextlib.suppress(subprocess.TimeoutExpired):
        assert any(fails(mutant.file, "\n".join(rows), arithmetic, tmp_path) for arithmetic in ARITHMETICS)


def fails(name: str, text: str, arithmetic: NumberType, folder: Path) -> bool:
    (written(folder, arithmetic) / name).write_text(text)
    return passes(compiled(folder, "-std=c99", "-O0", "-w")).returncode != 0
