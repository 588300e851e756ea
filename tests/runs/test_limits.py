"""A function reaches neither the results of its run nor more of the machine than it may."""

import shutil
import xml.etree.ElementTree as ET
from pathlib import Path

import pytest

from scripts.cases import ROOT, RUNS
from sigcat.cli import main
from sigcat.errors import UsageError
from sigcat.runs.running.process import Ring
from sigcat.runs.running.rows import Garbled, Layout, Progress, events, scanner
from sigcat.runs.running.sandbox import check_sandbox

CASE = ROOT / RUNS.folder / "one_function_feeds_another"
EXPECTED = (CASE / RUNS.expected).read_text()
RUN = ("simulate", "filter.yaml", "counter.yaml", "--trace", "trace.csv", "-o", "out.csv")
LAST = "    filter_out.mode = filter_in.mode;"
INCLUDES = "#define _DEFAULT_SOURCE\n#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n#include <unistd.h>\n#include <fcntl.h>\n"


def _has_sandbox():
    try:
        check_sandbox()
    except UsageError:
        return False
    return True


in_sandbox = pytest.mark.skipif(not _has_sandbox(), reason="bubblewrap: apt install bubblewrap")


@pytest.fixture
def run(tmp_path, monkeypatch, capfd):
    """Run the functions of a case, one of which does something in each step."""
    shutil.copytree(CASE, tmp_path, dirs_exist_ok=True)
    monkeypatch.chdir(tmp_path)

    def running(statement, *options):
        source = next(tmp_path.rglob("filter.c"))
        text = source.read_text().replace("#include <stdio.h>\n", INCLUDES)
        source.write_text(text.replace(LAST, f"{LAST}\n    {statement}"))
        status = main([*RUN, *options])
        said = capfd.readouterr().err.replace("what a function prints is no result\n", "")
        assert "Traceback" not in said
        return status, said

    return running


@pytest.mark.parametrize(
    "statement",
    [
        'for (int i = 3; i < 4096; i++) { (void)!write(i, "SSSSSSSSSSSSSSSSSSSSSSSSSSSSSSSS", 32); }',
        "for (int i = 0; i < (int)sysconf(_SC_OPEN_MAX); i++) { (void)close(i); }",
        "for (int i = 3; i < 64; i++) { (void)lseek(i, 0, SEEK_SET); (void)dup2(1, i); }",
        '(void)freopen("/dev/null", "w", stdout); (void)fclose(stderr); puts("x");',
    ],
    ids=["writes", "closes", "replaces", "redirects"],
)  # fmt: skip
def test_no_descriptor_leads_to_the_results(run, statement):
    assert run(statement)[0] == 0
    assert Path("out.csv").read_text() == EXPECTED


def _layout():
    return Layout((), (), ())


def _end(row):
    return b"E" + (2**32 - 1).to_bytes(4, "little") + bytes(8) + row.to_bytes(8, "little")


@pytest.mark.parametrize(
    ("data", "words"),
    [
        (_end(0) + _end(2), "row 2 is missing: row 3 follows row 1"),
        (_end(0) + _end(0), "row 2 is missing: row 1 follows row 1"),
        (_end(0) + b"x" * 13, "what follows row 1 cannot be read"),
        (b"S" + bytes(12), "what follows row 0 cannot be read"),
    ],
)
def test_a_row_that_is_missing_is_found(data, words):
    with pytest.raises(Garbled, match=words):
        list(events([data], _layout(), scanner(_layout()), Progress()))


def test_what_writes_over_the_results_is_told(run):
    """Their place is found in the list of mappings, as a wild pointer would find it by chance."""
    statement = (
        'char line[512]; FILE *maps = fopen("/proc/self/maps", "r"); unsigned long place = 0;\n'
        '    while (fgets(line, 512, maps)) { if (strstr(line, "/results")) { sscanf(line, "%lx", &place); } }\n'
        "    fclose(maps); if (place && filter_in.speed > 15) { memset((char *)place, 0x7f, 64); }"
    )
    status, said = run(statement)
    assert status == 1
    assert "error T024 The results must be complete" in said


def test_a_ring_is_taken_in_order(tmp_path):
    ring = Ring(tmp_path / "ring")
    assert ring.take() == b""
    ring.close()


def test_what_prints_without_end_is_stopped(run):
    line = "static char text[1 << 16]; memset(text, 120, sizeof(text)); for (int i = 0; i < 64; i++) { fwrite(text, 1, sizeof(text), stderr); }"  # fmt: skip
    status, said = run(line, "--output-limit", "1")
    assert status == 1
    assert said.count("x") < 1_100_000
    assert "error T025" in said


def test_a_file_that_grows_without_end_is_stopped(run):
    line = (
        'static char text[1 << 16]; FILE *file = fopen("grown", "w"); for (;;) { fwrite(text, 1, sizeof(text), file); }'
    )
    status, said = run(line, "--output-limit", "1")
    assert status == 1
    assert "SIGXFSZ" in said
    assert Path("grown").stat().st_size <= 1 << 20


def test_memory_is_limited(run):
    line = "void *large = malloc(1U << 30), *small = malloc(64U << 20); if (large || !small) { abort(); } free(small);"
    assert run(line, "--memory-limit", "256") == (0, "")


@in_sandbox
def test_a_sandbox_has_the_same_results_and_shows_nothing_else(run, tmp_path):
    (tmp_path / "secret").write_text("x")
    line = f'if (access("{tmp_path}/secret", F_OK) == 0 || open("{tmp_path}/made", O_CREAT | O_WRONLY, 0600) >= 0) {{ abort(); }}'
    assert run(line, "--sandbox") == (0, "")
    assert Path("out.csv").read_text() == EXPECTED


@in_sandbox
def test_a_crash_in_a_sandbox_is_told_by_its_signal(run):
    status, said = run("if (filter_in.speed > 15) { *(volatile int *)0 = 1; }", "--sandbox")
    assert status == 1
    assert "SIGSEGV (Segmentation fault)" in said


def test_without_bubblewrap_one_line_says_so(run, monkeypatch):
    monkeypatch.setattr(shutil, "which", lambda name, **_: None if name == "bwrap" else f"/usr/bin/{name}")
    status, said = run("", "--sandbox")
    assert status == 2
    assert said.startswith("sigcat: --sandbox needs bubblewrap")
    assert not Path("out.csv").exists()


def test_coverage_of_the_code_is_reported(run, monkeypatch):
    pytest.importorskip("gcovr", reason="coverage: pip install gcovr")
    if not (shutil.which("gcc") and shutil.which("gcov")):
        pytest.skip("coverage: gcc and gcov")
    monkeypatch.setenv("CC", "gcc")
    monkeypatch.setenv("CXX", "g++")
    status, said = run("if (filter_in.speed < -1000) { abort(); }", "--coverage", "covered")
    assert (status, said) == (0, "")
    assert Path("out.csv").read_text() == EXPECTED
    root = ET.parse("covered/coverage.xml").getroot()
    files = {each.get("filename", ""): float(each.get("line-rate", "0")) for each in root.iter("class")}
    assert sorted(Path(name).name for name in files) == ["counter.c", "filter.c"]
    assert all(rate > 0.5 for rate in files.values())
    assert float(root.get("branch-rate", "1")) < 1
    assert Path("covered/index.html").exists()


def test_coverage_without_gcovr_is_refused(run, monkeypatch):
    monkeypatch.setattr("sigcat.runs.building.coverage.find_spec", lambda _: None)
    status, said = run("", "--coverage", "covered")
    assert (status, said) == (
        2,
        "sigcat: --coverage needs the extra `coverage`: run `pip install 'sigcat[coverage]'`\n",
    )
