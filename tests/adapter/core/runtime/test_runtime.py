"""Functions in C that all cores share: each rule by a case, each branch reached, and each fault found."""

import contextlib
import json
import re
import shutil
import subprocess
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from sigcat.adapter.core.core_files import RUNTIME_SOURCE, runtime_files
from sigcat.adapter.core.numbers import DOUBLE, FLOAT, NumberType
from sigcat.adapter.core.plan import MICROSECONDS, MILLISECONDS, NANOSECONDS, Clock
from sigcat.adapter.toolchain import EXACT, toolchain
from tests.adapter.core.compilers import SANITIZERS, STRICT, sanitizers
from tests.needs import IS_SLOW_RUN

CASES, *INCLUDED = (Path(__file__).with_name(name) for name in ("cases.c", "float_cases.h", "tick_cases.h"))


class Variant(NamedTuple):
    """The shared files as one program has them."""

    arithmetic: NumberType
    clock: Clock


VARIANTS = {
    "double": Variant(DOUBLE, NANOSECONDS),
    "float": Variant(FLOAT, NANOSECONDS),
    "microseconds": Variant(FLOAT, MICROSECONDS),
    "milliseconds": Variant(FLOAT, MILLISECONDS),
}
BY_VARIANT = pytest.mark.parametrize("variant", VARIANTS.values(), ids=VARIANTS)
CLOCK = "sigcat_core_clock.h"
SOURCES = (
    (RUNTIME_SOURCE, NANOSECONDS),
    ("sigcat_core_functions.h", NANOSECONDS),
    (CLOCK, NANOSECONDS),
    (CLOCK, MILLISECONDS),
)
"""Files with functions, each once; those of other clocks are the same."""
CHANGES = (
    (r"(?<![<>=!-])>(?![>=])", ">="), (r">=", ">"), (r"(?<![<=])<(?![<=])", "<="), (r"<=", "<"),
    (r"==", "!="), (r"!=", "=="), (r"&&", "||"), (r"\|\|", "&&"), (r" \+ ", " - "), (r" - ", " + "), (r"\+\+", "--"),
    (r"--", "++"), (r"\+=", "-="), (r"\btrue\b", "false"), (r"\bfalse\b", "true"), (r"\b0U;", "1U;"),
)  # fmt: skip
EQUAL = re.compile(
    r"value [<>]= \(Sigcat_Real\)(?:least|most|0|INT64_MAX|UINT64_MAX)|-\(Sigcat_Real\)9223"  # the limit itself
    r"|value > 0\.0F?\) |value < 0\.0F?\) |value > DBL_MAX|value < -DBL_MAX"
    r"|return \((?:age_of_)?a [<>] (?:age_of_)?b\)|\(value [<>] (?:least|most)|\(value < 0\)|t > \*now|#if|-\(double\)FLT_MAX"
    r"|\(more > |\(value < \(Sigcat_Real\)INT64_MAX\)|value == value"
    r"|\(now - \*time\) > |\? \(now - \*release\)|\(\*skipped > "
    r"|value >= -FLT_MAX|source >= -FLT_MAX|-LargestSplit|value >= 0\.0F|value < 0\.0F"
)
"""Lines in which a limit and what is beside it give the same number."""


class Mutant(NamedTuple):
    """A change of one place."""

    file: str
    line: int
    text: str
    place: int
    clock: Clock


def text_of(name: str, clock: Clock) -> str:
    (data,) = (file.data for file in runtime_files(DOUBLE, clock) if file.name == name)
    return data.decode()


def mutants() -> Iterator[Mutant]:
    for name, clock in SOURCES:
        for number, line in enumerate(text_of(name, clock).partition("template <")[0].split("\n")):
            code = "" if line.startswith((" *", "#")) or EQUAL.search(line) else line.partition("/*")[0]
            for pattern, by in CHANGES:
                for found in re.finditer(pattern, code):
                    changed = f"{line[: found.start()]}{by}{line[found.end() :]}"
                    yield Mutant(name, number, changed, found.start(), clock)


@cache
def every_mutant() -> tuple[Mutant, ...]:
    return tuple(dict.fromkeys(mutants()))


def written(folder: Path, variant: Variant) -> Path:
    for file in runtime_files(*variant):
        (folder / file.name).write_bytes(file.data)
    for path in (CASES, *INCLUDED):
        shutil.copyfile(path, folder / path.name)
    return folder


def compiled(folder: Path, *flags: str) -> Path:
    command = [*toolchain().c, *flags, *EXACT, RUNTIME_SOURCE, CASES.name, "-o", "cases", "-lm"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return folder / "cases"


def passes(program: Path) -> subprocess.CompletedProcess[str]:
    return subprocess.run([program], cwd=program.parent, capture_output=True, text=True, check=False, timeout=20)


@BY_VARIANT
@pytest.mark.parametrize("standard", ["c99", "c11", "c17"])
def test_every_case_holds_without_a_warning(standard, variant, tmp_path):
    promotion = ("-Wdouble-promotion",) if variant.arithmetic == FLOAT else ()
    flags = (f"-std={standard}", *STRICT, *promotion, "-Wno-unused-function")
    done = passes(compiled(written(tmp_path, variant), *flags))
    assert (done.returncode, done.stdout) == (0, "")


@BY_VARIANT
def test_every_case_holds_under_sanitizers(variant, tmp_path):
    if not sanitizers():
        pytest.skip("sanitizers: a compiler that has them")
    done = passes(compiled(written(tmp_path, variant), "-std=c99", *SANITIZERS))
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")


@BY_VARIANT
def test_every_branch_is_taken(variant, tmp_path):
    if shutil.which("gcov") is None or "gcc" not in Path(toolchain().c[0]).name:
        pytest.skip("gcov: install gcc")
    passes(compiled(written(tmp_path, variant), "-std=c99", "-O0", "--coverage"))
    assert len(measured_lines(tmp_path, "sigcat_core", RUNTIME_SOURCE)) > 100
    lines = measured_lines(tmp_path, "cases", CLOCK)
    functions = re.findall(r"^static inline .*?(\w+)\(", text_of(CLOCK, variant.clock), re.MULTILINE)
    assert {line["function_name"] for line in lines} == set(functions)


def measured_lines(folder: Path, unit: str, name: str) -> list[dict[str, Any]]:
    """Lines of a file as a unit compiles it: each is reached, and each branch is taken."""
    (notes,) = folder.glob(f"*{unit}.gcda")
    done = subprocess.run(["gcov", "-b", "-j", "-t", notes.name], cwd=folder, capture_output=True, check=True)
    (file,) = (file for file in json.loads(done.stdout)["files"] if file["file"] == name)
    lines: list[dict[str, Any]] = file["lines"]
    missed = [line["line_number"] for line in lines if line["count"] == 0]
    missed += [line["line_number"] for line in lines for each in line["branches"] if each["count"] == 0]
    assert missed == []
    return lines


def test_there_are_many_faults():
    assert len(every_mutant()) > 100


@pytest.mark.parametrize(
    "mutant",
    every_mutant() if IS_SLOW_RUN else every_mutant()[::9],
    ids=lambda mutant: f"{mutant.file}-{mutant.line + 1}-{mutant.place}-{len(mutant.text)}-{mutant.clock.unit}",
)
def test_a_fault_is_found(mutant, tmp_path):
    rows = text_of(mutant.file, mutant.clock).split("\n")
    rows[mutant.line] = mutant.text
    with contextlib.suppress(subprocess.TimeoutExpired):
        variants = [each for each in VARIANTS.values() if each.clock == mutant.clock]
        assert any(fails(mutant.file, "\n".join(rows), each, tmp_path) for each in variants)


def fails(name: str, text: str, variant: Variant, folder: Path) -> bool:
    (written(folder, variant) / name).write_text(text)
    return passes(compiled(folder, "-std=c99", "-O0", "-w")).returncode != 0
